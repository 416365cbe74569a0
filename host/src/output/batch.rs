//! Files that appear together or not at all.

use super::OutputError;
use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};

/// Files being written under temporary names in one folder. [`Batch::commit`] gives them their own names;
/// dropped before that, the batch removes them.
pub struct Batch {
    folder: PathBuf,
    files: Vec<Pending>,
}

struct Pending {
    temporary: PathBuf,
    path: PathBuf,
}

impl Batch {
    /// A batch of files in `folder`, which is made if it does not exist.
    ///
    /// # Errors
    /// When the folder cannot be made.
    pub fn new(folder: &Path) -> Result<Self, OutputError> {
        std::fs::create_dir_all(folder).map_err(|source| refused("make the folder", folder, source))?;
        Ok(Self { folder: folder.to_owned(), files: Vec::new() })
    }

    /// Writes the file `name` by means of `encode`, under a temporary name.
    ///
    /// # Errors
    /// When the file cannot be written, or whatever `encode`, which is also given the file's own path for its
    /// errors, says.
    pub fn write(
        &mut self,
        name: &str,
        encode: impl FnOnce(&mut BufWriter<File>, &Path) -> Result<(), OutputError>,
    ) -> Result<(), OutputError> {
        let path = self.folder.join(name);
        let temporary = self.folder.join(format!(".{name}.{}.partial", std::process::id()));
        let file = File::create(&temporary).map_err(|source| refused("write", &path, source))?;
        self.files.push(Pending { temporary, path: path.clone() });
        let mut writer = BufWriter::new(file);
        encode(&mut writer, &path)?;
        writer.flush().map_err(|source| refused("write", &path, source))
    }

    /// Writes the file `name` with the lines of `text`.
    ///
    /// # Errors
    /// When the file cannot be written.
    pub fn write_text(&mut self, name: &str, text: &str) -> Result<(), OutputError> {
        self.write(name, |file, path| {
            writeln!(file, "{}", text.trim_end()).map_err(|source| refused("write", path, source))
        })
    }

    /// Gives all files their names and returns the paths.
    ///
    /// # Errors
    /// When a file cannot be renamed; those before it have been, those after it are removed.
    pub fn commit(mut self) -> Result<Vec<PathBuf>, OutputError> {
        let mut paths = Vec::new();
        while !self.files.is_empty() {
            let Pending { temporary, path } = &self.files[0];
            std::fs::rename(temporary, path).map_err(|source| refused("replace", path, source))?;
            paths.push(self.files.remove(0).path);
        }
        Ok(paths)
    }
}

impl Drop for Batch {
    fn drop(&mut self) {
        for file in &self.files {
            // There is nobody left to tell, and the error that brought us here matters more.
            let _ = std::fs::remove_file(&file.temporary);
        }
    }
}

fn refused(action: &'static str, path: &Path, source: std::io::Error) -> OutputError {
    OutputError::Files { action, path: path.to_owned(), source }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(folder: &Path) -> Vec<String> {
        let entries = std::fs::read_dir(folder).unwrap();
        let mut names: Vec<_> = entries.map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    fn put(batch: &mut Batch, name: &str, text: &str) {
        batch.write_text(name, text).unwrap();
    }

    #[test]
    fn files_appear_when_all_are_complete() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("a"), "old").unwrap();
        let mut batch = Batch::new(folder.path()).unwrap();
        put(&mut batch, "a", "new");
        put(&mut batch, "b", "new");
        assert_eq!(std::fs::read(folder.path().join("a")).unwrap(), b"old");
        let paths = batch.commit().unwrap();
        assert_eq!(paths, ["a", "b"].map(|name| folder.path().join(name)));
        assert_eq!(names(folder.path()), ["a", "b"]);
        assert_eq!(std::fs::read(folder.path().join("a")).unwrap(), b"new\n");
    }

    #[test]
    fn an_error_leaves_everything_as_it_was() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("a"), "old").unwrap();
        let mut batch = Batch::new(folder.path()).unwrap();
        put(&mut batch, "a", "new");
        let full = std::io::Error::from(std::io::ErrorKind::StorageFull);
        assert!(batch.write("b", |_, path| Err(refused("write", path, full))).is_err());
        assert_eq!(names(folder.path()).len(), 3);
        drop(batch);
        assert_eq!(names(folder.path()), ["a"]);
        assert_eq!(std::fs::read(folder.path().join("a")).unwrap(), b"old");
    }

    #[test]
    fn a_file_is_no_folder() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("file");
        std::fs::write(&file, "").unwrap();
        let error = Batch::new(&file).err().unwrap().to_string();
        assert!(error.starts_with("cannot make the folder"), "{error}");
    }
}
