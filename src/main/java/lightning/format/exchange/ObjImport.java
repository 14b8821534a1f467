package lightning.format.exchange;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import lightning.base.file.UnusableFileException;
import lightning.base.math.Rgb;
import lightning.base.math.Transform;
import lightning.base.work.Progress;
import lightning.format.MeshFormat;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.exchange.assembly.PrincipledImport;
import lightning.format.exchange.assembly.SceneAssembler;
import lightning.format.exchange.assembly.TextureMeans;
import lightning.format.exchange.assembly.TransmissionImport;
import lightning.format.gltf.MeshFileWriter;
import lightning.format.jen.asset.TextureFile;
import lightning.format.mesh.ByteSource;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.NamedMesh;
import lightning.format.mesh.obj.MtlImage;
import lightning.format.mesh.obj.MtlMaterial;
import lightning.format.mesh.obj.MtlReader;
import lightning.format.mesh.obj.ObjFile;
import lightning.format.mesh.obj.ObjReader;
import lightning.format.mesh.ply.PlyReader;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.asset.TextureUsage;
import lightning.scene.asset.TextureWrap;
import lightning.scene.material.AlphaCutout;
import lightning.scene.material.BumpMapping;
import lightning.scene.material.Coat;
import lightning.scene.material.LayerMaps;
import lightning.scene.material.Material;
import lightning.scene.material.Sheen;
import lightning.scene.node.Mesh;
import lightning.scene.value.Placement;
import lightning.scene.value.SceneLimits;

/** Converter for mesh-only files: OBJ with its material files, and PLY. */
final class ObjImport {
    /** Degrees of a turn. */
    private static final double TURN = 360;
    /** Index of refraction of surfaces whose own is 1 or less, which some writers use for none. */
    private static final double DEFAULT_IOR = 1.5;
    private static final double MIN_REPEAT = 1e-6;
    /** Height of a height map's white, as a share of the radius of the scene. */
    private static final double BUMP_HEIGHT = 0.01;

    private final SceneAssembler assembler;
    private double radius = 1;
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
        try (ByteSource bytes = ByteSource.openText(source, progress)) {
            Mesh mesh = PlyReader.read(bytes, importer.assembler.notes);
            importer.addPart(importer.assembler.addFile(source), MeshFormat.SINGLE_PART_NAME, Material.DEFAULT.name(), mesh);
        }
        return importer.assembler.build();
    }

    static ImportedScene importObj(Path source, Path sceneFile, Progress progress) throws IOException, MeshException {
        return new ObjImport(source, sceneFile, progress).importObj();
    }

    private ImportedScene importObj() throws IOException, MeshException {
        ObjFile file;
        try (ByteSource bytes = ByteSource.openText(source, progress)) {
            file = ObjReader.read(bytes, assembler.notes);
        }
        for (String libraries : file.libraries()) {
            // A line names one file, whose name may have spaces, or several.
            for (String library : siblingFile(libraries).isPresent() ? new String[] {libraries} : libraries.split("\\s+")) {
                readLibrary(library);
            }
        }
        radius = radius(file.parts());
        // Scenes have no offset of textures: meshes of such materials are written with other coordinates.
        List<NamedMesh> moved = new ArrayList<>();
        String movedFile = assembler.stem() + ".placed.glb";
        for (ObjFile.ObjPart part : file.parts()) {
            String material = materialName(part.material());
            Optional<Mesh> mesh = Optional.ofNullable(mtlMaterials.get(part.material())).flatMap(ObjImport::placedImage)
                    .filter(MtlImage::isMoved).filter(_ -> part.mesh().coordinates() != null).flatMap(image -> moved(part.mesh(), image));
            if (mesh.isPresent()) {
                moved.add(new NamedMesh(part.name(), mesh.get()));
                addPart(movedFile, part.name(), material, mesh.get());
            } else {
                addPart(assembler.addFile(source), part.name(), material, part.mesh());
            }
        }
        if (!moved.isEmpty()) {
            assembler.addFile(movedFile, MeshFileWriter.write(moved));
        }
        return assembler.build();
    }

    /** Returns half the largest extent of all meshes along an axis. */
    private static double radius(List<ObjFile.ObjPart> parts) {
        double radius = 0;
        for (int axis = 0; axis < 3; axis++) {
            double min = Double.POSITIVE_INFINITY;
            double max = Double.NEGATIVE_INFINITY;
            for (ObjFile.ObjPart part : parts) {
                float[] p = part.mesh().positions();
                for (int i = axis; i < p.length; i += 3) {
                    min = Math.min(min, p[i]);
                    max = Math.max(max, p[i]);
                }
            }
            radius = Math.max(radius, (max - min) / 2);
        }
        return radius;
    }

    /** Returns the image whose placement all images of a material share here. */
    private static Optional<MtlImage> placedImage(MtlMaterial m) {
        return images(m).findFirst();
    }

    private static Stream<MtlImage> images(MtlMaterial m) {
        MtlMaterial.Physical surface = m.physical().orElse(MtlMaterial.Physical.NONE);
        Stream<MtlImage> numbers = Stream.of(surface.roughnessMap(), surface.metalnessMap(), surface.coatMap(), surface.coatRoughnessMap())
                .flatMap(Optional::stream).map(MtlMaterial.FactorMap::image);
        return Stream.concat(Stream.of(m.texture(), m.bump(), m.emissionMap(), m.cutout()).flatMap(Optional::stream), numbers);
    }

    /** Returns a mesh whose coordinates have an image's offset, in units of its repetitions; empty, with a note, if they would be too large. */
    private Optional<Mesh> moved(Mesh mesh, MtlImage image) {
        float[] coordinates = requireNonNull(mesh.coordinates()).clone();
        for (int i = 0; i < coordinates.length; i += 2) {
            coordinates[i] += (float) (image.offsetU() / repeat(image.scaleU()));
            coordinates[i + 1] += (float) (image.offsetV() / repeat(image.scaleV()));
        }
        for (float v : coordinates) {
            if (!(Math.abs(v) <= Mesh.MAX_TEXTURE_COORDINATE)) {
                assembler.notes.add("offsets (-o) of textures that are too large, left out");
                return Optional.empty();
            }
        }
        return Optional.of(new Mesh(mesh.positions(), mesh.triangles(), mesh.normals(), coordinates, mesh.colors()));
    }

    private void addPart(String file, String part, String material, Mesh mesh) {
        assembler.nodes.add(assembler.createShape(part, file, part, mesh, material, Placement.IDENTITY, Transform.IDENTITY));
    }

    private void readLibrary(String name) throws IOException, MeshException {
        Optional<Path> file = siblingFile(name);
        if (file.isEmpty()) {
            assembler.notes.add("missing material files");
            return;
        }
        try (ByteSource bytes = ByteSource.openText(file.get(), progress)) {
            MtlReader.read(bytes, assembler.notes).forEach(mtlMaterials::putIfAbsent);
        }
    }

    /** Returns a file in this file's folder or below it. */
    private Optional<Path> siblingFile(String name) throws IOException {
        return assembler.images.find(name);
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
        Material opaque = withGlow(m, m.physical().isPresent() ? physical(m, m.physical().get(), diffuse) : switch (m.illumination()) {
            case CONSTANT -> constant(m, diffuse);
            case DIFFUSE, HIGHLIGHT, REFLECTION, GLASS, FRESNEL, REFRACTION, FRESNEL_REFRACTION, REFLECTION_MAP, GLASS_MAP,
                    SHADOW_CATCHER ->
                    highlightMaterial(m).withDiffuse(diffuse).withTexture(textureMap(m.texture(), TextureUsage.COLOR));
        });
        Optional<TextureMap> cutout = textureMap(m.cutout(), TextureUsage.OPACITY);
        assembler.notes.add("opacity maps (map_d), imported as cutouts at half opacity", cutout.isPresent() ? 1 : 0);
        notePlacements(m);
        return withBump(m, withSurfaceMaps(m, withLayers(m, withTransmission(m, opaque))).withCutout(AlphaCutout.NONE.withMap(cutout)));
    }

    /** Notes images that are placed apart from others of their material. */
    private void notePlacements(MtlMaterial m) {
        Optional<MtlImage> placed = placedImage(m);
        boolean isApart = images(m).anyMatch(image -> !image.isMovedLike(placed.orElseThrow()));
        assembler.notes.add("textures with another offset (-o) than others of their material, placed like them", isApart ? 1 : 0);
    }

    /** Adds a bump map. Writers use its statements for images of heights, which are gray, and of normals, which are mostly blue. */
    private Material withBump(MtlMaterial m, Material material) throws IOException {
        Optional<TextureMap> map = textureMap(m.bump(), TextureUsage.DATA);
        if (map.isEmpty()) {
            return material;
        }
        boolean isNormal =
                m.bump().get().isNormal() || assembler.images.bytes(m.bump().get().path()).filter(ObjImport::isNormalMap).isPresent();
        double multiplier = m.bump().get().multiplier();
        if (isNormal) {
            return material.withBumpMapping(BumpMapping.NONE.withNormalMap(map)
                    .withStrength(Math.clamp(multiplier, -SceneLimits.MAX_STRENGTH, SceneLimits.MAX_STRENGTH)));
        }
        assembler.notes.add("height maps (map_Bump), whose height is guessed from the size of the scene");
        return material.withBumpMapping(BumpMapping.NONE.withBump(map).withHeight(
                SceneAssembler.clamp(Math.abs(multiplier) * BUMP_HEIGHT * radius, SceneLimits.MAX_HEIGHT) * Math.signum(multiplier)));
    }

    private static boolean isNormalMap(byte[] image) {
        try {
            Texture texture = TextureFile.decode("bump", image, TextureUsage.DATA);
            return TextureMeans.mean(texture, 2) > 0.6 && Math.abs(TextureMeans.mean(texture, 0) - 0.5) < 0.15
                    && Math.abs(TextureMeans.mean(texture, 1) - 0.5) < 0.15;
        } catch (UnusableFileException e) {
            return false;
        }
    }

    /** Adds the emission. Some writers leave its color (Ke) black where an image (map_Ke) has the colors. */
    private Material withGlow(MtlMaterial m, Material material) throws IOException {
        Rgb emission = assembler.clampColor(m.emission(), SceneLimits.MAX_EMISSION, "emission of materials");
        if (m.emissionMap().isEmpty()) {
            return material.withGlow(emission);
        }
        Optional<TextureMap> map = textureMap(m.emissionMap(), TextureUsage.COLOR);
        return map.isEmpty() ? material : material.withGlow(emission.isBlack() ? Rgb.WHITE : emission).withGlowMap(map);
    }

    /** Returns a principled surface, from the statements Pr, Pm and Ni. */
    private Material physical(MtlMaterial m, MtlMaterial.Physical surface, Rgb base) throws IOException {
        return PrincipledImport.material(base, surface.metalness(), surface.roughness())
                .withF0(PrincipledImport.f0(m.ior() > 1 ? m.ior() : DEFAULT_IOR)).withTexture(textureMap(m.texture(), TextureUsage.COLOR));
    }

    /** Adds the maps of roughness and metalness, map_Pr and map_Pm; a transparent material has none. */
    private Material withSurfaceMaps(MtlMaterial m, Material material) throws IOException {
        MtlMaterial.Physical surface = m.physical().orElse(MtlMaterial.Physical.NONE);
        if (material.isClear()) {
            assembler.notes.add("map_Pr of transparent materials", surface.roughnessMap().isPresent() ? 1 : 0);
            assembler.notes.add("map_Pm of transparent materials", surface.metalnessMap().isPresent() ? 1 : 0);
            return material;
        }
        Optional<TextureMap> roughness = map(surface.roughnessMap());
        Optional<TextureMap> metalness = map(surface.metalnessMap());
        Material rough = roughness.isEmpty() ? material
                : material.withRoughness(SceneAssembler.clamp(surface.roughnessMap().get().factor(), 1));
        Material metallic = metalness.isEmpty() ? rough
                : rough.withMetalness(SceneAssembler.clamp(surface.metalnessMap().get().factor(), 1));
        return metallic.withSurfaceMaps(metallic.surfaceMaps().withRoughness(roughness).withMetalness(metalness));
    }

    private Optional<TextureMap> map(Optional<MtlMaterial.FactorMap> map) throws IOException {
        return textureMap(map.map(MtlMaterial.FactorMap::image), TextureUsage.DATA);
    }

    /** Adds the coat with its maps, map_Pc and map_Pcr, and the sheen. */
    private Material withLayers(MtlMaterial m, Material material) throws IOException {
        MtlMaterial.Physical surface = m.physical().orElse(MtlMaterial.Physical.NONE);
        var principled = new PrincipledImport(assembler);
        Optional<TextureMap> coat = map(surface.coatMap());
        Optional<TextureMap> roughness = map(surface.coatRoughnessMap());
        double weight = coat.isPresent() ? surface.coatMap().orElseThrow().factor() : surface.coat();
        double blur = roughness.isPresent() ? surface.coatRoughnessMap().orElseThrow().factor() : surface.coatRoughness();
        Material coated = principled.withCoat(material, weight, blur, Coat.NONE.ior());
        Material mapped = coated.coat().isVisible()
                ? coated.withLayerMaps(LayerMaps.NONE.withCoat(coat).withCoatRoughness(roughness)) : coated;
        Material layered = principled.withSheen(mapped, Rgb.gray(surface.sheen()), Sheen.NONE.roughness());
        return principled.withBurleyAnisotropy(layered, SceneAssembler.clamp(surface.anisotropy(), 1), TURN * surface.anisotropyRotation());
    }

    /** Returns a surface of constant color, independent of lighting. It is ambient light, since the surface is no light source. */
    private Material constant(MtlMaterial m, Rgb color) throws IOException {
        Optional<TextureMap> map = textureMap(m.texture(), TextureUsage.COLOR);
        Material unlit = Material.of("material").withDiffuse(Rgb.BLACK);
        return map.isEmpty() ? unlit.withAmbient(color) : unlit.withGlow(color).withGlowMap(map);
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

    private Optional<TextureMap> textureMap(Optional<MtlImage> image, TextureUsage usage) throws IOException {
        return image.isEmpty() ? Optional.empty() : assembler.images.file(image.get().path(), usage)
                .map(map -> map.withRepeatU(repeat(image.get().scaleU())).withRepeatV(repeat(image.get().scaleV()))
                        .withWrap(image.get().isClamped() ? TextureWrap.CLAMP : TextureWrap.REPEAT));
    }

    private static double repeat(double scale) {
        double limited = Math.clamp(scale, -SceneLimits.MAX_REPEAT, SceneLimits.MAX_REPEAT);
        return Math.abs(limited) < MIN_REPEAT ? 1 : limited;
    }

    /** Adds transmission; a model without refraction becomes a veil of its filter color. */
    private Material withTransmission(MtlMaterial m, Material opaque) {
        return new TransmissionImport(assembler).withTransmission(opaque, 1 - SceneAssembler.clamp(m.opacity(), 1),
                assembler.clampColor(m.filter(), 1, "filters of materials"),
                m.illumination().isRefractive() ? m.ior() : 1, !m.illumination().isRefractive(), 0);
    }
}
