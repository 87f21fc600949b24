//! Nets for `subcert refine`, `limit`, `oracle` and `depth`.

use super::mesh::{deliver, in_form, input, note_what_is_lost, noted};
use super::mesh_form::OF_NETS;
use super::mesh_input::text_of;
use super::polygon::empty_line;
use crate::cli::arguments::{ClosedArgument, MeshOutput, MeshOutputFormat, OracleFormat};
use crate::cli::console::answer::SCHEMA;
use crate::cli::console::output::{Failure, Outcome, note};
use crate::cli::console::progress::Progress;
use std::path::Path;
use subcert::diagnostic::SourceText;
use subcert::exact::{Rational, RealCyclotomic};
use subcert::mesh::{
    LimitPoint, NoNormal, PolygonMesh, to_json, to_obj, to_off, to_ply, to_stl, without_normals,
};
use subcert::net::{Closed, Net, NetError, NetFormat, NetRules, net_of_limits, read_net, to_csv};

/// What is asked of a net.
pub(crate) struct NetInput<'a> {
    pub(crate) scheme: &'a str,
    pub(crate) path: &'a Path,
    pub(crate) closed: Option<ClosedArgument>,
}

/// A net with what refines it, and the name of its file.
pub(crate) struct NetFile {
    pub(crate) scheme: NetRules,
    pub(crate) name: String,
    pub(crate) net: Net,
    /// What is to be told of the file.
    pub(crate) notes: Vec<String>,
}

impl NetInput<'_> {
    /// Whether this is a net: by the extension of the file, or because it is said which directions are
    /// closed.
    pub(crate) fn is_net(&self) -> bool {
        self.closed.is_some() || NetFormat::of(self.path).is_some()
    }

    pub(crate) fn read(&self) -> Result<NetFile, Failure> {
        let scheme = NetRules::parse(self.scheme).map_err(failure)?;
        let (name, net, notes) = self.net()?;
        Ok(NetFile { scheme, name, net, notes })
    }

    /// The name of the file, the net in it, and what is to be told of it.
    fn net(&self) -> Result<(String, Net, Vec<String>), Failure> {
        let path = self.path;
        let extension = path.extension().unwrap_or_default().to_ascii_lowercase();
        if ["obj", "off", "ply"].iter().any(|mesh| extension == *mesh) {
            return Err(Failure::Input(format!(
                "--closed is for nets in .csv or .json, and `{}` is a polygon mesh: its faces say what \
                 is closed",
                path.display()
            )));
        }
        let (name, text) = text_of(path)?;
        let format = NetFormat::of(path).unwrap_or_else(|| NetFormat::of_text(&text));
        let closed = self.closed.map(|closed| match closed {
            ClosedArgument::None => Closed { u: false, v: false },
            ClosedArgument::U => Closed { u: true, v: false },
            ClosedArgument::V => Closed { u: false, v: true },
            ClosedArgument::Uv => Closed { u: true, v: true },
        });
        let source = SourceText::new(name.clone(), text);
        let net = read_net(&source, format, closed)?;
        let told = empty_line(&source, ["rows", "net"]).filter(|_| format == NetFormat::Csv);
        Ok((name, net, told.into_iter().collect()))
    }

    /// The net in the file, with its notes on the standard error.
    fn told(&self) -> Result<NetFile, Failure> {
        let file = self.read()?;
        file.notes.iter().for_each(|told| note(told));
        Ok(file)
    }
}

pub(crate) fn failure(error: NetError) -> Failure {
    match error {
        NetError::Scheme(error) => error.into(),
        NetError::TooFew { direction, .. } => {
            let closed = if direction == 0 { "u" } else { "v" };
            Failure::Input(format!("{error} with --closed {closed}"))
        }
        error => Failure::Input(error.to_string()),
    }
}

pub(crate) fn refine(asked: &NetInput<'_>, level: u32, output: &MeshOutput) -> Outcome {
    let format = OF_NETS.chosen(output)?;
    let file = asked.told()?;
    let _progress = Progress::of_mesh(format!("refining to level {level}"));
    let net = file.scheme.refined(&file.net, level).map_err(failure)?;
    let title = file.title(level, "refined");
    let text = match format {
        MeshOutputFormat::Json => file.json(&net, level, None)?,
        format => text(&net, format, &title)?,
    };
    deliver(output, &text)
}

pub(crate) fn limit(asked: &NetInput<'_>, level: u32, output: &MeshOutput) -> Outcome {
    let format = OF_NETS.chosen(output)?;
    let file = asked.told()?;
    let _progress = Progress::of_mesh(format!("refining to level {level}"));
    let net = file.scheme.refined(&file.net, level).map_err(failure)?;
    let title = file.title(level, "limit points of its points");
    let text = match format {
        MeshOutputFormat::Json => file.json(&net, level, Some(&file.limits(&net)?))?,
        format => {
            let limits =
                net_of_limits(&net, file.scheme.limits(&net).map_err(failure)?).map_err(failure)?;
            text(&limits, format, &title)?
        }
    };
    deliver(output, &text)
}

/// What `subcert oracle --mesh` writes.
pub(crate) fn reference_values(
    asked: &NetInput<'_>,
    level: u32,
    format: OracleFormat,
) -> Result<String, Failure> {
    let file = asked.told()?;
    let _progress = Progress::of_mesh(format!("refining to level {level}"));
    let net = file.scheme.refined(&file.net, level).map_err(failure)?;
    let limits = file.limits(&net)?;
    if format == OracleFormat::Json {
        return file.json(&net, level, Some(&limits));
    }
    let meshes = [(&polygons(&file.net)?).into(), (&polygons(&net)?).into()];
    in_form(&meshes, &limits, level, &file.head(&net, level, &file.notes), format)
}

fn polygons(net: &Net) -> Result<PolygonMesh<RealCyclotomic>, Failure> {
    Ok(net.mesh().map_err(|error| input(&error))?.map(real))
}

fn text(net: &Net, format: MeshOutputFormat, title: &str) -> Result<String, Failure> {
    if format == MeshOutputFormat::Csv {
        return to_csv(net, title).map_err(|error| input(&error));
    }
    let mesh = polygons(net)?;
    note_what_is_lost(&mesh, format, false);
    match format {
        MeshOutputFormat::Ply => to_ply(&mesh, title),
        MeshOutputFormat::Off => to_off(&mesh, title),
        MeshOutputFormat::Stl => to_stl(&mesh, title),
        _ => to_obj(&mesh, title, &[]),
    }
    .map_err(|error| input(&error))
}

fn real(x: &Rational) -> RealCyclotomic {
    x.clone().into()
}

/// A limit point without a normal.
pub(crate) fn limit_at(point: [Rational; 3]) -> LimitPoint {
    let normal = Err(NoNormal::NotComputed);
    LimitPoint { position: point.map(Into::into), normal, sectors: Vec::new() }
}

impl NetFile {
    fn title(&self, level: u32, what: &str) -> String {
        format!("{}, {}, level {level}: {what}", self.name, self.scheme.name())
    }

    fn limits(&self, net: &Net) -> Result<Vec<Option<LimitPoint>>, Failure> {
        let limits = self.scheme.limits(net).map_err(failure)?.into_iter();
        Ok(limits.map(|point| point.map(limit_at)).collect())
    }

    fn json(
        &self,
        net: &Net,
        level: u32,
        limits: Option<&[Option<LimitPoint>]>,
    ) -> Result<String, Failure> {
        let notes = self.notes.iter().cloned().chain(limits.and_then(without_normals));
        let notes: Vec<String> = notes.collect();
        Ok(to_json(&polygons(net)?, &self.head(net, level, &notes), limits))
    }

    fn head(&self, net: &Net, level: u32, notes: &[String]) -> Vec<(&'static str, String)> {
        let text = |text: &str| serde_json::Value::from(text).to_string();
        let mut head = vec![
            ("schema", SCHEMA.to_string()),
            ("scheme", text(self.scheme.name())),
            ("mesh", text(&self.name)),
            ("level", level.to_string()),
            ("rows", net.rows().to_string()),
            ("columns", net.columns().to_string()),
            ("closed", text(net.closed().name())),
        ];
        head.extend(noted(notes));
        head
    }
}
