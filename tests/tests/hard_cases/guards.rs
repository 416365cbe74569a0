//! The list of guards is up to date: each one's text stands once in its file, and the tests that hold it exist.

use parallax::verify::CASES;
use parallax_tests::scenes::root;
use parallax_tests::terminal::tried;

fn text(table: &toml::Table, key: &str) -> String {
    table.get(key).and_then(|value| value.as_str()).unwrap_or_else(|| panic!("{table}: no `{key}`")).into()
}

/// Whether a test of this name is in the test target.
fn is_defined(target: &str, function: &str) -> bool {
    if target == "hard_cases" {
        return CASES.iter().any(|case| format!("{}::{}", case.group, case.name) == function);
    }
    let file = root().join("tests/tests").join(target).with_extension("rs");
    std::fs::read_to_string(file).unwrap().contains(&format!("fn {function}("))
}

#[test]
fn every_guard_stands_where_the_list_says_and_its_tests_exist() {
    let list = std::fs::read_to_string(root().join("tests/guards.toml")).unwrap();
    let list: toml::Table = list.parse().unwrap();
    let guards = list["guard"].as_array().unwrap();
    for guard in guards {
        let guard = guard.as_table().unwrap();
        let (name, file, find) = (text(guard, "name"), text(guard, "file"), text(guard, "find"));
        let source = std::fs::read_to_string(root().join(&file)).unwrap();
        assert_eq!(source.matches(&find).count(), 1, "{name}: `{find}` in {file}");
        assert_ne!(find, text(guard, "replace"), "{name}");
        let (target, test) = (text(guard, "target"), text(guard, "test"));
        assert!(is_defined(&target, &test), "{name}: {target} has no {test}");
    }
    tried("guards on the list", guards.len() as u64, "");
}
