use reference::compare::{
    Coverage, Errors, Report, colours, coverage, depths, frame, hit_histogram, psnr, texel_error,
};
use reference::image::Image;
use reference::transform::Viewport;
use topleft::Wrap;

#[test]
fn cracks_and_double_hits_are_told_apart() {
    let found = coverage(&[1, 0, 2, 1, 0], &[1, 1, 1, 1, 2]);
    assert_eq!(found, Coverage { pixels: 5, missing: 2, extra: 1, first: Some(1) });
    assert_eq!(coverage(&[3, 0], &[3, 0]).first, None);
    assert_eq!(hit_histogram(&[1, 0, 3, 1, 1]), [1, 3, 0, 1]);
    assert_eq!(hit_histogram(&[]), [0; 0]);
}

#[test]
#[should_panic(expected = "one size")]
fn frames_of_two_sizes_are_refused() {
    coverage(&[1, 1], &[1]);
}

#[test]
fn errors_have_both_signs_and_none_is_lost() {
    let errors: Errors = [1.0, -3.0, 2.0].into_iter().collect();
    assert_eq!((errors.count, errors.max, errors.worst, errors.mean()), (3, 3.0, 1, 2.0));
    assert_eq!(Errors::default().mean(), 0.0);
    assert_eq!([0.0, f64::NAN].into_iter().collect::<Errors>().max, f64::INFINITY);
    // The worst channel counts, in either direction, and so does one that is no number.
    let reference = [[10.0, 20.0, 30.0], [0.0; 3]];
    let found = colours(&[[11.0, 16.0, 32.0], [0.0; 3]], &reference);
    assert_eq!((found.max, found.mean()), (4.0, 2.0));
    assert_eq!(colours(&[[10.0, f64::NAN, 30.0], [0.0; 3]], &reference).max, f64::INFINITY);
    // 7.9 is stored as 7.
    let found = depths(&[7, 5, 9], &[7.9, 7.0, 8.0]);
    assert_eq!((found.max, found.worst, found.mean()), (2.0, 1, 1.0));
}

#[test]
fn texels_are_near_across_the_seam() {
    assert_eq!(texel_error(63.75, 0.25, 64, Wrap::Repeat), 0.5);
    assert_eq!(texel_error(-127.75, 0.5, 64, Wrap::Repeat), 0.25);
    assert_eq!(texel_error(10.0, 42.0, 64, Wrap::Repeat), 32.0);
    assert_eq!(texel_error(63.75, 0.25, 64, Wrap::Clamp), 63.5);
    assert_eq!(texel_error(70.0, 64.5, 64, Wrap::Clamp), 0.0);
    assert_eq!(texel_error(-3.0, 1.0, 64, Wrap::Clamp), 1.0);
}

#[test]
fn psnr_of_known_images() {
    let grey = [[100; 3]; 50];
    assert_eq!(psnr(&grey, &grey), f64::INFINITY);
    assert_eq!(psnr(&[], &[]), f64::INFINITY);
    // All off by one: 20 log10 255.
    assert!((psnr(&[[101; 3]; 50], &grey) - 48.130_803_608_679).abs() < 1e-9);
    // One channel of three off by 30, in one pixel of two: a mean square of 150.
    assert!((psnr(&[[100, 70, 100], [100; 3]], &[[100; 3]; 2]) - 26.369_891_018_561).abs() < 1e-9);
    // Black against white.
    assert_eq!(psnr(&[[255; 3]; 4], &[[0; 3]; 4]), 0.0);
}

#[test]
fn a_report_is_one_line_of_what_was_compared() {
    let reference = Image::new(Viewport { width: 2, height: 1 }, [10.0, 20.4, 30.0]);
    let ours = [[10.0, 20.4, 30.0], [11.5, 20.4, 30.0]];
    let mut report = frame("two pixels", &ours, Some(&[0, 3]), &reference);
    report.coverage = Some(coverage(&[1, 2], &[1, 1]));
    assert_eq!(
        report.to_string(),
        "two pixels: 2 px, 0 missing, 1 extra; colour max 1.5000 mean 0.7500 of 255; \
         depth max 3.0000 mean 1.5000 codes; PSNR 49.89 dB"
    );
    let texels = Report { name: "floor".into(), texel: Some(Errors::default()), ..Report::default() };
    assert_eq!(texels.to_string(), "floor: texel max 0.0000 mean 0.0000 texels");
    // 11.5 becomes 12: what is compared on 8 bits is rounded.
    assert_eq!(report.psnr, Some(psnr(&[[10, 20, 30], [12, 20, 30]], &[[10, 20, 30]; 2])));
}
