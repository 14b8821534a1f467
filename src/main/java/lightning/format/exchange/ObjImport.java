package lightning.format.exchange;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.base.math.Transform;
import lightning.base.work.Progress;
import lightning.format.MeshFormat;
import lightning.format.mesh.ByteSource;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.obj.MtlMaterial;
import lightning.format.mesh.obj.MtlReader;
import lightning.format.mesh.obj.ObjFile;
import lightning.format.mesh.obj.ObjReader;
import lightning.format.mesh.ply.PlyReader;
import lightning.scene.Cutout;
import lightning.scene.Limits;
import lightning.scene.Material;
import lightning.scene.Mesh;
import lightning.scene.Placement;
import lightning.scene.TextureMap;

/** Makes scenes of files that hold meshes alone: OBJ with the materials beside it, and PLY. */
final class ObjImport {
    private final Pieces pieces;
    private final Path source;
    private final Progress progress;
    private final Map<String, MtlMaterial> found = new HashMap<>();
    private final Map<String, String> names = new HashMap<>();

    private ObjImport(Path source, Path to, Progress progress) {
        this.source = source;
        this.progress = progress;
        pieces = new Pieces(source, to);
    }

    static Import ply(Path source, Path to, Progress progress) throws IOException, MeshException {
        var made = new ObjImport(source, to, progress);
        try (ByteSource bytes = ByteSource.open(source, progress)) {
            Mesh mesh = PlyReader.read(bytes, made.pieces.notes);
            made.add(MeshFormat.ONLY_PART, Material.DEFAULT.name(), mesh);
        }
        return made.pieces.finish();
    }

    static Import obj(Path source, Path to, Progress progress) throws IOException, MeshException {
        return new ObjImport(source, to, progress).obj();
    }

    private Import obj() throws IOException, MeshException {
        ObjFile file;
        try (ByteSource bytes = ByteSource.open(source, progress)) {
            file = ObjReader.read(bytes, pieces.notes);
        }
        for (String library : file.libraries()) {
            library(library);
        }
        for (ObjFile.ObjPart part : file.parts()) {
            add(part.name(), material(part.material()), part.mesh());
        }
        return pieces.finish();
    }

    private void add(String part, String material, Mesh mesh) {
        pieces.nodes.add(pieces.shape(part, pieces.name(source), part, mesh, material, Placement.IDENTITY, Transform.IDENTITY));
    }

    private void library(String name) throws IOException, MeshException {
        Optional<Path> file = beside(name);
        if (file.isEmpty()) {
            pieces.notes.add("files of materials that are not there");
            return;
        }
        try (ByteSource bytes = ByteSource.open(file.get(), progress)) {
            MtlReader.read(bytes, pieces.notes).forEach(found::putIfAbsent);
        }
    }

    /** A file in the folder of this one, or in one inside it. */
    private Optional<Path> beside(String name) throws IOException {
        try {
            Path folder = source.toRealPath().getParent();
            Path file = folder.resolve(name.replace('\\', '/')).normalize();
            return Files.isRegularFile(file) && file.toRealPath().startsWith(folder) ? Optional.of(file) : Optional.empty();
        } catch (InvalidPathException e) {
            return Optional.empty();
        }
    }

    private String material(String name) throws IOException {
        if (name.isEmpty()) {
            return Material.DEFAULT.name();
        }
        String known = names.get(name);
        if (known == null) {
            MtlMaterial m = found.get(name);
            pieces.notes.add("materials that are not there", m == null ? 1 : 0);
            known = pieces.material(name, m == null ? Material.DEFAULT : made(m));
            names.put(name, known);
        }
        return known;
    }

    private Material made(MtlMaterial m) throws IOException {
        Rgb diffuse = pieces.color(m.diffuse(), 1, "diffuse colours of materials");
        Rgb emission = pieces.color(m.emission(), Limits.MAX_EMISSION, "emission of materials");
        Material opaque = switch (m.illumination()) {
            case CONSTANT -> constant(m, diffuse.plus(emission));
            case DIFFUSE, HIGHLIGHT, REFLECTION, GLASS, FRESNEL, REFRACTION, FRESNEL_REFRACTION, REFLECTION_MAP, GLASS_MAP,
                    SHADOW_CATCHER ->
                    lit(m).withDiffuse(diffuse).withAmbient(emission).withTexture(picture(m.texture()));
        };
        Optional<TextureMap> cutout = picture(m.cutout());
        pieces.notes.add("pictures of what is there (map_d), cut out here where half of it is", cutout.isPresent() ? 1 : 0);
        return clear(m, opaque).withCutout(Cutout.NONE.withCutout(cutout));
    }

    /** A surface of one color, whatever lights it. */
    private Material constant(MtlMaterial m, Rgb color) {
        pieces.notes.add("textures of unlit materials", m.texture().isPresent() ? 1 : 0);
        return Material.of("material").withAmbient(color).withDiffuse(Rgb.BLACK);
    }

    /** With the highlights and the mirrored rays of its model alone. */
    private Material lit(MtlMaterial m) {
        Rgb specular = pieces.color(m.specular(), 1, "specular colours of materials");
        Material plain = Material.of("material").withReflective(m.illumination().mirrors() ? specular : Rgb.BLACK);
        if (!m.highlights()) {
            pieces.notes.add("highlights of exponents (Ns) below 1", m.illumination().highlights() && !specular.isBlack() ? 1 : 0);
            return plain;
        }
        return plain.withSpecular(specular)
                .withShininess(Pieces.clamp(m.shininess().orElse(plain.shininess()), Limits.MAX_SHININESS));
    }

    private Optional<TextureMap> picture(Optional<String> file) throws IOException {
        Optional<Path> picture = file.isEmpty() ? Optional.empty() : beside(file.get());
        if (picture.isPresent() && Pieces.isPicture(picture.get())) {
            return Pieces.texture(pieces.name(picture.get()));
        }
        pieces.notes.add("textures that are not there, or no PNG or JPEG", file.isPresent() ? 1 : 0);
        return Optional.empty();
    }

    /** What bends no light by its model is a veil of its filter's colour. */
    private Material clear(MtlMaterial m, Material opaque) {
        return new SeeThrough(pieces).made(opaque, 1 - Pieces.clamp(m.opacity(), 1), pieces.color(m.filter(), 1, "filters of materials"),
                m.illumination().refracts() ? m.ior() : 1, !m.illumination().refracts(), 0);
    }
}
