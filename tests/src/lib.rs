//! What the tests of Parallax share.
