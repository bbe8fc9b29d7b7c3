//! Where the names of a chart's points find room.

/// Width of a letter of a name, rather more than it takes, and its height.
pub(super) const LETTER: [f64; 2] = [5.9, 12.0];
/// Between a point and its name.
pub(super) const GAP: f64 = 8.0;
/// How far a name may lie from its point.
const REACH: f64 = 110.0;

/// A rectangle: left, top, right and bottom.
pub(super) type Area = [f64; 4];

pub(super) fn overlap(a: &Area, b: &Area) -> bool {
    a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3]
}

/// Whether a line comes into a rectangle, looked at in small steps.
fn crosses([from_x, from_y]: [f64; 2], [to_x, to_y]: [f64; 2], area: &Area) -> bool {
    const STEPS: u32 = 24;
    (0..=STEPS).map(|step| f64::from(step) / f64::from(STEPS)).any(|share| {
        let (x, y) = (from_x + share * (to_x - from_x), from_y + share * (to_y - from_y));
        (area[0]..=area[2]).contains(&x) && (area[1]..=area[3]).contains(&y)
    })
}

/// The place of a rectangle that is nearest to a point.
pub(super) fn nearest(area: &Area, x: f64, y: f64) -> [f64; 2] {
    [x.clamp(area[0], area[2]), y.clamp(area[1], area[3])]
}

/// What names may not cover.
pub(super) struct Taken {
    /// Within which they lie.
    room: Area,
    points: Vec<Area>,
    names: Vec<Area>,
    /// What they cover only where there is no other room: the front's lines.
    lines: Vec<Area>,
    /// Lines from points to names.
    leads: Vec<[[f64; 2]; 2]>,
}

impl Taken {
    /// No name yet.
    pub(super) const fn new(room: Area, points: Vec<Area>, lines: Vec<Area>) -> Self {
        Self { room, points, names: Vec::new(), lines, leads: Vec::new() }
    }

    fn is_free(&self, area: &Area, lead: &[[f64; 2]; 2]) -> bool {
        let room = &self.room;
        let is_within = area[0] >= room[0] && area[1] >= room[1] && area[2] <= room[2] && area[3] <= room[3];
        is_within
            && !self.points.iter().chain(&self.names).any(|other| overlap(area, other))
            && !self.leads.iter().any(|[from, to]| crosses(*from, *to, area))
            && !self.names.iter().any(|other| crosses(lead[0], lead[1], other))
    }

    /// The area for a name near `(x, y)` that covers nothing, and nothing covers; takes it. `None` where there is no room.
    pub(super) fn place(&mut self, name: &str, x: f64, y: f64) -> Option<Area> {
        const RINGS: u32 = 18;
        const TURNS: u32 = 16;
        let half = [LETTER[0] * name.chars().count() as f64 / 2.0, LETTER[1] / 2.0];
        let around = |[center_x, center_y]: [f64; 2]| {
            [center_x - half[0], center_y - half[1], center_x + half[0], center_y + half[1]]
        };
        let candidates = (0..RINGS).flat_map(|ring| {
            let away = GAP + (REACH - GAP) * f64::from(ring) / f64::from(RINGS - 1);
            (0..TURNS).map(move |turn| {
                let (up, side) = (std::f64::consts::TAU * f64::from(turn) / f64::from(TURNS)).sin_cos();
                // A name's edge, not its middle, is so far away.
                [x + side * away + side.signum() * half[0] * side.abs().min(1.0), y - up * (away + half[1])]
            })
        });
        let is_free = |area: &Area| self.is_free(area, &[[x, y], nearest(area, x, y)]);
        let is_apart = |area: &Area| self.lines.iter().all(|line| !overlap(area, line));
        let areas: Vec<Area> = candidates.map(around).filter(is_free).collect();
        let found = *areas.iter().find(|area| is_apart(area)).or(areas.first())?;
        self.names.push(found);
        self.leads.push([[x, y], nearest(&found, x, y)]);
        Some(found)
    }
}
