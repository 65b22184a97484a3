//! What the demo promises of every frame of its turn: its size on the panel, that it fits the memory of the images, and 30
//! frames a second.

use pico::{Memory, PANEL, STRIP_CELLS, Show, TRIANGLES, WORDS};
use topleft::{Depth16, DrawList, ListTriangle, NoDepth, Pixel, Strip};

const PIXELS: usize = (PANEL.width * PANEL.height) as usize;

/// What the demo is for: triangles drawn, and a part of the panel's pixels.
const LEAST_TRIANGLES: usize = 1000;
const LEAST_PIXELS: usize = PIXELS * 2 / 5;
/// All memory that an image uses, of which so much is left for the stack: `docs/measured/ram.csv` says what it takes.
const RAM: usize = 64 * 1024;
const STACK: usize = 4 * 1024;
/// Cycles that a frame of the image `dma` may take, at the RP2040's 133 MHz: `docs/measured/turn.csv` says what it takes.
const CYCLES: u32 = 133_000_000 / 30;

/// Red when: a hill hides too many triangles from some side, the camera moves away, or the list is too small for a frame.
#[test]
fn every_frame_is_full_and_fits() {
    let mut show = Show::new();
    assert_eq!(show.scene().name, "demo");
    let background = u16::from_rgb(show.scene().background);
    let (mut memory, mut colours) = (Box::<Memory>::default(), vec![0; PIXELS]);
    let mut least = (usize::MAX, usize::MAX);
    loop {
        // Without depth as many pixels are covered.
        let mut list: DrawList<'_, u16, NoDepth> = memory.list();
        assert_eq!(show.draw(&mut list), 0, "{show:?} does not fit");
        let mut strip = Strip::new(PANEL.width as u16, &mut colours).unwrap().with_background(background);
        strip.clear();
        list.render(0..PANEL.height as i32, &mut strip);
        let covered = strip.colours().iter().filter(|&&colour| colour != background).count();
        least = (least.0.min(list.stats().drawn), least.1.min(covered));
        show = show.next_frame();
        if show == Show::new() {
            break;
        }
    }
    println!("at least {} triangles and {} pixels", least.0, least.1);
    assert!(least.0 >= LEAST_TRIANGLES && least.1 >= LEAST_PIXELS, "{least:?}");
}

/// Red when: the list is not emptied before each frame, or what does not fit is not counted.
#[test]
fn what_does_not_fit_is_counted() {
    let (mut words, mut triangles) = ([0; WORDS], [ListTriangle::EMPTY; 10]);
    let mut list: DrawList<'_, u16, Depth16> = DrawList::new(&mut words, &mut triangles);
    let left_out = Show::new().draw(&mut list);
    assert_eq!(list.stats().drawn, 10);
    assert!(left_out >= LEAST_TRIANGLES - 10);
    assert_eq!(Show::new().draw(&mut list), left_out);
}

/// Red when: strips or list grow beyond what the demo promises.
#[test]
fn buffers_and_stack_fit_a_chip_of_64_kb() {
    let strips = 3 * STRIP_CELLS * size_of::<u16>();
    let list = WORDS * size_of::<u32>() + TRIANGLES * size_of::<ListTriangle>();
    assert!(strips + list + STACK <= RAM, "{strips} + {list} + {STACK}");
}

/// Red when: a frame of the turn is measured that takes longer, or some frames are not counted.
#[test]
fn the_slowest_frame_is_in_time() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/measured/turn.csv");
    let table = std::fs::read_to_string(path).unwrap();
    let mut lines = table.lines().filter(|line| !line.starts_with('#'));
    let (columns, cells) = (lines.next().unwrap().split(','), lines.next().unwrap().split(','));
    let cells: Vec<_> = columns.zip(cells).collect();
    let cell = |name: &str| cells.iter().find(|(column, _)| *column == name).unwrap().1;
    assert_eq!([cell("panel"), cell("image"), cell("scene")], ["240x240", "dma", Show::new().scene().name]);
    // All but the first, which is sent as a whole.
    let others = std::iter::successors(Some(Show::new().next_frame()), |show| Some(show.next_frame()))
        .take_while(|&show| show != Show::new());
    assert_eq!(cell("frames").parse(), Ok(others.count()));
    let slowest: u32 = cell("cycles_slowest").parse().unwrap();
    assert!(slowest <= CYCLES, "frame {} takes {slowest} cycles of {CYCLES}", cell("slowest_frame"));
}
