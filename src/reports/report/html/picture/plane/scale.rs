//! From values to places on a picture.

/// A scale from the values `from` to the places `to`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scale {
    from: (f64, f64),
    to: (f64, f64),
    log: bool,
}

impl Scale {
    /// A linear scale, or a logarithmic one of positive values.
    pub(crate) fn new(from: (f64, f64), to: (f64, f64), log: bool) -> Scale {
        let (low, high) = if log { (from.0.log10(), from.1.log10()) } else { from };
        // A single value stands in the middle.
        let from = if high > low { (low, high) } else { (low - 0.5, high + 0.5) };
        Scale { from, to, log }
    }

    /// The place of a value, to a tenth of a pixel.
    pub(crate) fn at(&self, value: f64) -> f64 {
        let value = if self.log { value.log10() } else { value };
        let part = (value - self.from.0) / (self.from.1 - self.from.0);
        let place = self.to.0 + part * (self.to.1 - self.to.0);
        (place * 10.0).round() / 10.0
    }

    /// Round values on it, at most some ten, with their labels.
    pub(crate) fn ticks(&self) -> Vec<(f64, String)> {
        if self.log { self.powers() } else { self.multiples() }
    }

    fn powers(&self) -> Vec<(f64, String)> {
        let (low, high) = (self.from.0.ceil(), self.from.1.floor());
        let step = ((high - low) / 8.0).ceil().max(1.0);
        let mut ticks = Vec::new();
        let mut power = low;
        while power <= high {
            ticks.push((10_f64.powf(power), superscript(power)));
            power += step;
        }
        ticks
    }

    fn multiples(&self) -> Vec<(f64, String)> {
        let (low, high) = self.from;
        let rough = (high - low) / 6.0;
        let power = 10_f64.powf(rough.log10().floor());
        let step = [1.0, 2.0, 5.0, 10.0].map(|times| times * power);
        let step = step.into_iter().find(|step| *step >= rough).unwrap_or(rough);
        // As many decimals as the step has.
        let digits = (0..20_i32).find(|digits| power * 10_f64.powi(*digits) > 0.999);
        let digits = usize::try_from(digits.unwrap_or(20)).unwrap_or(0);
        let mut ticks = Vec::new();
        let mut place = (low / step).ceil();
        while place * step <= high {
            let value = place * step;
            // Not −0.
            ticks.push((value, format!("{:.digits$}", value + 0.0)));
            place += 1.0;
        }
        ticks
    }
}

/// `10⁻³`; `1` and `10` as they are.
fn superscript(power: f64) -> String {
    let digits = format!("{power:.0}");
    if digits == "0" || digits == "-0" {
        return "1".to_owned();
    }
    let raised = |c: char| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '4' => '⁴',
        '5' => '⁵',
        '6' => '⁶',
        '7' => '⁷',
        '8' => '⁸',
        '9' => '⁹',
        _ => '⁰',
    };
    if digits == "1" {
        "10".to_owned()
    } else {
        format!("10{}", digits.chars().map(raised).collect::<String>())
    }
}
