//! The command `parallax`: see `parallax --help`.

mod command;

fn main() -> std::process::ExitCode {
    command::main()
}
