//! Methods that infer a second view, and how they are asked to.

use crate::render::{First, Method, StereoOptions, Verify};

/// The methods that make the second view from the first, that of the lower bound aside.
pub const REPROJECTING: [Method; 7] = [
    Method::Scanline,
    Method::ScanlineRtl,
    Method::EsIsler,
    Method::Gather1,
    Method::Gather2,
    Method::Buffer,
    Method::Atomic,
];

/// `method` with this verification.
pub fn verified(method: Method, verify: Verify, first: First) -> StereoOptions {
    StereoOptions { verify: Some(verify), first, ..method.into() }
}
