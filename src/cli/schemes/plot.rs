//! `subcert plot`.

use crate::cli::arguments::{BOXES, PlotArguments};
use crate::cli::console::output::{Failure, Outcome, deliver};
use crate::cli::console::progress::Progress;
use crate::cli::ranges::smooth_map::region;
use subcert::facts::Drawing;
use subcert::report::html::Plot;
use subcert::scheme::open_parameters;

pub(crate) fn plot(arguments: &PlotArguments) -> Outcome {
    let PlotArguments { scheme, bounds, file } = arguments;
    if let Some(path) = file.as_deref().filter(|path| path.is_dir()) {
        let path = path.display();
        let message = format!("`{path}` is a folder: name a file for the picture with -o FILE.svg");
        return Err(Failure::Input(message));
    }
    let open = open_parameters(scheme).unwrap_or_default();
    let region = match (&open[..], bounds) {
        ([first, second], _) => region(bounds.as_deref(), [first, second]),
        (_, None) => region(None, [scheme, scheme]),
        (_, Some(_)) => Err(format!(
            "--bounds: they are those of two parameters without a value, which `{scheme}` does not have"
        )),
    };
    let region = region.map_err(Failure::Input)?;
    let progress = Progress::of_search(true);
    let drawing = Drawing::of(scheme, &region, BOXES)?;
    drop(progress);
    deliver(&Plot::of(scheme, &drawing).to_svg(), file.as_deref())
}
