//! The largest strain of stretch links.

use kerchief::host::Simulation;

/// The largest strain now and since the start. Once the strain of a link is undefined, `most` stays undefined.
#[derive(Clone, Copy, Debug)]
pub(super) struct Watched {
    pub(super) now: f64,
    pub(super) most: f64,
}

impl Watched {
    pub(super) fn start(simulation: &dyn Simulation) -> Self {
        let now = largest(simulation);
        Self { now, most: now }
    }

    pub(super) fn follow(&mut self, simulation: &dyn Simulation) {
        self.now = largest(simulation);
        if self.now > self.most || self.now.is_nan() {
            self.most = self.now;
        }
    }
}

/// The largest strain now. Every scene has stretch links: a scene file without them is refused.
fn largest(simulation: &dyn Simulation) -> f64 {
    simulation.strains().stretch.map_or(f64::NAN, |strain| strain.largest)
}

/// The strain in percent, in few characters for any value.
pub(super) fn percent(strain: f64) -> String {
    let percent = 100.0 * strain;
    if percent.is_nan() {
        "undefined".to_string()
    } else if percent < 1000.0 {
        format!("{percent:.2} %")
    } else {
        format!("{percent:.1e} %")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_strain_is_written_short() {
        let written = [0.0, 0.012_34, 9.99, 12.0, 1e300, f64::INFINITY, f64::NAN].map(percent);
        assert_eq!(written, ["0.00 %", "1.23 %", "999.00 %", "1.2e3 %", "1.0e302 %", "inf %", "undefined"]);
    }
}
