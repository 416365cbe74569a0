//! The CPU: one invocation at a time.

#[inline(always)]
pub fn mul_high(a: u32, b: u32) -> u32 {
    ((a as u64 * b as u64) >> 32) as u32
}

#[inline(always)]
pub fn sqrt(a: f32) -> f32 {
    a.sqrt()
}

#[inline(always)]
pub fn fma(a: f32, b: f32, c: f32) -> f32 {
    a.mul_add(b, c)
}

pub fn barrier() {
    panic!("a barrier outside a device")
}

#[inline(always)]
pub fn subgroup_size() -> u32 {
    1
}

#[inline(always)]
pub fn subgroup_lane() -> u32 {
    0
}

#[inline(always)]
pub fn subgroup_add(value: u32) -> u32 {
    value
}

#[inline(always)]
pub fn subgroup_min(value: u32) -> u32 {
    value
}

#[inline(always)]
pub fn subgroup_max(value: u32) -> u32 {
    value
}

#[inline(always)]
pub fn subgroup_any(value: bool) -> bool {
    value
}

#[inline(always)]
pub fn subgroup_all(value: bool) -> bool {
    value
}

#[inline(always)]
pub fn subgroup_read(value: u32, _lane: u32) -> u32 {
    value
}

#[inline(always)]
pub fn subgroup_count(value: bool) -> u32 {
    value as u32
}
