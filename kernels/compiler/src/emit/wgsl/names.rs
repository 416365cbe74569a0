//! Names that a kernel cannot have in WGSL. The entry point must keep the kernel's name, so such a kernel is
//! refused.

/// Keywords and reserved words (WGSL, "Keyword and Token Summary").
const RESERVED: &str = "\
NULL Self abstract active alias alignas alignof as asm asm_fragment async attribute auto await \
become break case cast catch class co_await co_return co_yield coherent column_major common \
compile compile_fragment concept const const_assert const_cast consteval constexpr constinit \
continue continuing crate debugger decltype default delete demote demote_to_helper diagnostic \
discard do dynamic_cast else enable enum explicit export extends extern external fallthrough \
false filter final finally fn for friend from fxgroup get goto groupshared highp if impl \
implements import inline instanceof interface layout let loop lowp macro macro_rules match \
mediump meta mod module move mut mutable namespace new nil noexcept noinline nointerpolation \
non_coherent noncoherent noperspective null nullptr of operator override package packoffset \
partition pass patch pixelfragment precise precision premerge priv protected pub public readonly \
ref regardless register reinterpret_cast require requires resource restrict return self set \
shared sizeof smooth snorm static static_assert static_cast std struct subroutine super switch \
target template this thread_local throw trait true try type typedef typeid typename typeof union \
unless unorm unsafe unsized use using var varying virtual volatile wgsl where while with \
writeonly yield";

/// What a text declares or names outside of the entry point's body, besides roots and constants.
const OWN: &str =
    "u32 f32 bool array atomic vec3 vec4 bitcast Push mul_high uniform storage workgroup read read_write";

/// Why an entry point cannot be called `name` in a text with this body, if it cannot.
pub fn objection(name: &str, body: &str) -> Option<&'static str> {
    let among = |words: &str| words.split(' ').any(|word| word == name);
    if among(RESERVED) || name.starts_with("__") || name == "_" {
        Some("is a reserved word")
    } else if among(OWN) || is_numbered(name) || is_used(name, body) {
        Some("is the name of something else")
    } else {
        None
    }
}

/// Whether the name is like those of roots, constants and other things that a text declares.
fn is_numbered(name: &str) -> bool {
    ["r", "spec", "bits_"].iter().any(|prefix| {
        let number = name.strip_prefix(prefix);
        number.is_some_and(|number| !number.is_empty() && number.bytes().all(|b| b.is_ascii_hexdigit()))
    })
}

/// Whether the body names `name`: a function of WGSL, a variable or a parameter.
fn is_used(name: &str, body: &str) -> bool {
    let outside = |c: char| !(c.is_alphanumeric() || c == '_');
    body.split(outside).any(|word| word == name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_word_that_naga_reserves_is_known() {
        let unknown = |word: &&str| objection(word, "").is_none();
        let unknown: Vec<_> = naga::keywords::wgsl::RESERVED.iter().copied().filter(unknown).collect();
        assert!(unknown.is_empty(), "{unknown:?}");
    }

    #[test]
    fn a_function_that_the_kernel_calls_cannot_be_its_name() {
        let body = "let v7 = select(v1, r2[v2], v3);";
        for name in ["select", "v7", "r3", "spec0", "vec4", "uniform"] {
            assert!(objection(name, body).is_some(), "{name}");
        }
        for name in ["sel", "trace", "rays", "compute", "specialised"] {
            assert!(objection(name, body).is_none(), "{name}");
        }
    }
}
