package lightning.format.exchange;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import lightning.base.file.ParentFolder;
import lightning.base.math.Rgb;
import lightning.base.math.Transform;
import lightning.base.work.Progress;
import lightning.format.MeshFormat;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.exchange.assembly.SceneAssembler;
import lightning.format.exchange.assembly.TransmissionImport;
import lightning.format.mesh.ByteSource;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.obj.MtlMaterial;
import lightning.format.mesh.obj.MtlReader;
import lightning.format.mesh.obj.ObjFile;
import lightning.format.mesh.obj.ObjReader;
import lightning.format.mesh.ply.PlyReader;
import lightning.scene.asset.TextureMap;
import lightning.scene.material.AlphaCutout;
import lightning.scene.material.Material;
import lightning.scene.node.Mesh;
import lightning.scene.value.Placement;
import lightning.scene.value.SceneLimits;

/** Converter for mesh-only files: OBJ with its material files, and PLY. */
final class ObjImport {
    private final SceneAssembler assembler;
    private final Path source;
    private final Progress progress;
    private final Map<String, MtlMaterial> mtlMaterials = new HashMap<>();
    private final Map<String, String> materialNames = new HashMap<>();

    private ObjImport(Path source, Path sceneFile, Progress progress) {
        this.source = source;
        this.progress = progress;
        assembler = new SceneAssembler(source, sceneFile);
    }

    static ImportedScene importPly(Path source, Path sceneFile, Progress progress) throws IOException, MeshException {
        var importer = new ObjImport(source, sceneFile, progress);
        try (ByteSource bytes = ByteSource.open(source, progress)) {
            Mesh mesh = PlyReader.read(bytes, importer.assembler.notes);
            importer.addPart(MeshFormat.SINGLE_PART_NAME, Material.DEFAULT.name(), mesh);
        }
        return importer.assembler.build();
    }

    static ImportedScene importObj(Path source, Path sceneFile, Progress progress) throws IOException, MeshException {
        return new ObjImport(source, sceneFile, progress).importObj();
    }

    private ImportedScene importObj() throws IOException, MeshException {
        ObjFile file;
        try (ByteSource bytes = ByteSource.open(source, progress)) {
            file = ObjReader.read(bytes, assembler.notes);
        }
        for (String library : file.libraries()) {
            readLibrary(library);
        }
        for (ObjFile.ObjPart part : file.parts()) {
            addPart(part.name(), materialName(part.material()), part.mesh());
        }
        return assembler.build();
    }

    private void addPart(String part, String material, Mesh mesh) {
        assembler.nodes
                .add(assembler.createShape(part, assembler.addFile(source), part, mesh, material, Placement.IDENTITY, Transform.IDENTITY));
    }

    private void readLibrary(String name) throws IOException, MeshException {
        Optional<Path> file = siblingFile(name);
        if (file.isEmpty()) {
            assembler.notes.add("missing material files");
            return;
        }
        try (ByteSource bytes = ByteSource.open(file.get(), progress)) {
            MtlReader.read(bytes, assembler.notes).forEach(mtlMaterials::putIfAbsent);
        }
    }

    /** Returns a file in this file's folder or below it. */
    private Optional<Path> siblingFile(String name) throws IOException {
        try {
            Path folder = ParentFolder.of(source.toRealPath());
            Path file = folder.resolve(name.replace('\\', '/')).normalize();
            return Files.isRegularFile(file) && file.toRealPath().startsWith(folder) ? Optional.of(file) : Optional.empty();
        } catch (InvalidPathException e) {
            return Optional.empty();
        }
    }

    private String materialName(String name) throws IOException {
        if (name.isEmpty()) {
            return Material.DEFAULT.name();
        }
        String cached = materialNames.get(name);
        if (cached == null) {
            MtlMaterial m = mtlMaterials.get(name);
            assembler.notes.add("missing materials", m == null ? 1 : 0);
            cached = assembler.addMaterial(name, m == null ? Material.DEFAULT : convert(m));
            materialNames.put(name, cached);
        }
        return cached;
    }

    private Material convert(MtlMaterial m) throws IOException {
        Rgb diffuse = assembler.clampColor(m.diffuse(), 1, "diffuse colors of materials");
        Material opaque = withGlow(m, switch (m.illumination()) {
            case CONSTANT -> constant(m, diffuse);
            case DIFFUSE, HIGHLIGHT, REFLECTION, GLASS, FRESNEL, REFRACTION, FRESNEL_REFRACTION, REFLECTION_MAP, GLASS_MAP,
                    SHADOW_CATCHER ->
                    highlightMaterial(m).withDiffuse(diffuse).withTexture(textureMap(m.texture()));
        });
        Optional<TextureMap> cutout = textureMap(m.cutout());
        assembler.notes.add("opacity maps (map_d), imported as cutouts at half opacity", cutout.isPresent() ? 1 : 0);
        return withTransmission(m, opaque).withCutout(AlphaCutout.NONE.withMap(cutout));
    }

    /** Adds the emission. Some writers leave its color (Ke) black where an image (map_Ke) has the colors. */
    private Material withGlow(MtlMaterial m, Material material) throws IOException {
        Rgb emission = assembler.clampColor(m.emission(), SceneLimits.MAX_EMISSION, "emission of materials");
        if (m.emissionMap().isEmpty()) {
            return material.withGlow(emission);
        }
        Optional<TextureMap> map = textureMap(m.emissionMap());
        return map.isEmpty() ? material : material.withGlow(emission.isBlack() ? Rgb.WHITE : emission).withGlowMap(map);
    }

    /** Returns a surface of constant color, independent of lighting. It is ambient light, since the surface is no light source. */
    private Material constant(MtlMaterial m, Rgb color) {
        assembler.notes.add("textures of unlit materials", m.texture().isPresent() ? 1 : 0);
        return Material.of("material").withAmbient(color).withDiffuse(Rgb.BLACK);
    }

    /** Returns a material with only the highlights and reflections of its illumination model. */
    private Material highlightMaterial(MtlMaterial m) {
        Rgb specular = assembler.clampColor(m.specular(), 1, "specular colors of materials");
        Material result = Material.of("material").withReflective(m.illumination().isReflective() ? specular : Rgb.BLACK);
        if (!m.hasHighlights()) {
            assembler.notes.add("highlights of exponents (Ns) below 1", m.illumination().hasHighlights() && !specular.isBlack() ? 1 : 0);
            return result;
        }
        return result.withSpecular(specular)
                .withShininess(SceneAssembler.clamp(m.shininess().orElse(result.shininess()), SceneLimits.MAX_SHININESS));
    }

    private Optional<TextureMap> textureMap(Optional<String> file) throws IOException {
        Optional<Path> path = file.isEmpty() ? Optional.empty() : siblingFile(file.get());
        if (path.isPresent() && SceneAssembler.isPngOrJpeg(path.get())) {
            return SceneAssembler.placeholderTexture(assembler.addFile(path.get()));
        }
        assembler.notes.add("textures that are missing, or not PNG or JPEG", file.isPresent() ? 1 : 0);
        return Optional.empty();
    }

    /** Adds transmission; a model without refraction becomes a veil of its filter color. */
    private Material withTransmission(MtlMaterial m, Material opaque) {
        return new TransmissionImport(assembler).withTransmission(opaque, 1 - SceneAssembler.clamp(m.opacity(), 1),
                assembler.clampColor(m.filter(), 1, "filters of materials"),
                m.illumination().isRefractive() ? m.ior() : 1, !m.illumination().isRefractive(), 0);
    }
}
