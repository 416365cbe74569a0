//! The list of guards is up to date: each one's text stands once in its file, and the tests that hold it exist.

use parallax_tests::scenes::root;
use std::path::Path;

fn text(table: &toml::Table, key: &str) -> String {
    table.get(key).and_then(|value| value.as_str()).unwrap_or_else(|| panic!("{table}: no `{key}`")).into()
}

/// Whether a function of this name is defined in the test target.
fn is_defined(target: &str, function: &str) -> bool {
    let tests = root().join("tests/tests");
    let folder = tests.join(target);
    let files: Vec<_> = match std::fs::read_dir(&folder) {
        Ok(entries) => entries.map(|entry| entry.unwrap().path()).collect(),
        Err(_) => vec![tests.join(target).with_extension("rs")],
    };
    let name = function.rsplit("::").next().unwrap();
    let defines = |path: &Path| std::fs::read_to_string(path).unwrap().contains(&format!("fn {name}("));
    files.iter().any(|path| defines(path))
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
    super::backends::tried("guards on the list", guards.len());
}
