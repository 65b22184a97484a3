//! What several test binaries share: counters, inputs biased to where methods fail, and a runner with fixed seeds.
#![allow(dead_code, unused_imports, reason = "each test binary uses a part of it")]

pub(crate) mod coded;
pub(crate) mod counter;
mod difference;
pub(crate) mod exact;
pub(crate) mod frame;
pub(crate) mod guarded;
pub(crate) mod measured;
pub(crate) mod polygons;
pub(crate) mod stats;
pub(crate) mod strategies;
pub(crate) mod tolerance;
pub(crate) mod winding;

pub(crate) use difference::same;

use std::fmt::Debug;

use proptest::strategy::Strategy;
use proptest::test_runner::{Config, RngAlgorithm, TestCaseError, TestRng, TestRunner};

/// Runs `test` on `cases` values, the same ones every time, and panics with the smallest value that it finds to fail.
#[track_caller]
pub(crate) fn check<S: Strategy>(cases: u32, strategy: &S, test: impl Fn(S::Value) -> Result<(), String>)
where
    S::Value: Debug,
{
    let config = Config { cases, failure_persistence: None, max_shrink_iters: 10_000, ..Config::default() };
    let rng = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let result =
        TestRunner::new_with_rng(config, rng).run(strategy, |value| test(value).map_err(TestCaseError::fail));
    if let Err(error) = result {
        panic!("{error}");
    }
}
