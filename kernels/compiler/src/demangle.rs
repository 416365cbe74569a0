//! Names of functions as the user wrote them.

/// The path that a symbol stands for, without its hash; other names as they are.
pub fn demangle(symbol: &str) -> String {
    format!("{:#}", rustc_demangle::demangle(symbol))
}

#[cfg(test)]
mod tests {
    use super::demangle;

    #[test]
    fn both_manglings_and_none() {
        assert_eq!(demangle("_ZN4kern5types4wide17h82936cdc34782682E"), "kern::types::wide");
        assert_eq!(
            demangle("_RNvNtCsgEmfK2I1SDS_4core6option13unwrap_failed"),
            "core::option::unwrap_failed"
        );
        assert_eq!(demangle("tanf"), "tanf");
    }
}
