package lightning.format.exchange;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.format.gltf.GltfMaterial;
import lightning.format.gltf.GltfScene;
import lightning.format.jen.TextureDecoder;
import lightning.format.mesh.MeshException;
import lightning.scene.AlphaCutout;
import lightning.scene.BumpMapping;
import lightning.scene.Material;
import lightning.scene.SceneLimits;
import lightning.scene.ShadingModel;
import lightning.scene.TextureMap;

/** Makes metallic materials of a glTF file's, and tells what they cannot say. */
final class GltfMaterialImport {
    /** The image in a rougher surface is blurred by more than 3° to each side: there its highlight has half its height (GGX). */
    private static final double MAX_MIRROR_ROUGHNESS = 0.2;

    private final SceneAssembler assembler;
    private final GltfScene file;
    private final String meshFile;
    private final Map<Integer, Optional<String>> images = new HashMap<>();
    private final Map<Integer, TextureMeans> textureMeans = new HashMap<>();
    private final Map<Integer, Optional<Rgb>> emissionMeans = new HashMap<>();

    /** @param meshFile the name of the glTF file beside the scene */
    GltfMaterialImport(SceneAssembler assembler, GltfScene file, String meshFile) {
        this.assembler = assembler;
        this.file = file;
        this.meshFile = meshFile;
    }

    Material convert(GltfMaterial m) throws IOException, MeshException {
        Rgb base = assembler.clampColor(m.base(), 1, "base colors of materials");
        if (m.isUnlit()) {
            assembler.notes.add("textures of unlit materials", m.baseImage() < 0 ? 0 : 1);
            return Material.of("material").withAmbient(base).withDiffuse(Rgb.BLACK);
        }
        TextureMeans means = m.metallicRoughnessImage() < 0 ? TextureMeans.NONE : metallicRoughnessMeans(m.metallicRoughnessImage());
        Material material = Material.of("material").withModel(ShadingModel.METALLIC).withBase(base)
                .withAmbient(
                        assembler.clampColor(m.emission().times(emissionTextureMean(m)), SceneLimits.MAX_EMISSION, "emission of materials"))
                .withMetalness(SceneAssembler.clamp(m.metallic() * means.metalness(), 1))
                .withRoughness(SceneAssembler.clamp(m.roughness() * means.roughness(), 1)).withTexture(textureMap(m.baseImage()));
        return withCutout(withNormalMap(withTransmission(withReflection(withHighlights(material, m)), m), m), m);
    }

    /** With what a surface mirrors of lights where it is no metal: a gray share here, and all of it where it is grazed. */
    private Material withHighlights(Material material, GltfMaterial m) {
        Rgb f0 = assembler.clampColor(m.f0(), 1, "highlights of materials");
        boolean isGray = f0.min() == f0.max();
        if (material.metalness() < 1) {
            assembler.notes.add("colored highlights of materials that are no metals, gray here", isGray ? 0 : 1);
            assembler.notes.add("highlights of materials weakened where they are grazed, not weakened here", m.f90() == 1 ? 0 : 1);
        }
        return material.withF0(isGray ? f0.r() : Math.min(f0.luminance(), 1));
    }

    /**
     * With mirrored shapes where it is a metal all over and so smooth that they are sharp. Each pixel of such a surface costs as many rays as
     * the picture is deep, and {@code reflective} knows no picture, and weakens what the surface emits; so all other metals show lights alone.
     */
    private Material withReflection(Material material) {
        boolean isMirror = material.metalness() == 1 && material.roughness() <= MAX_MIRROR_ROUGHNESS && material.texture().isEmpty()
                && material.ambient().isBlack();
        assembler.notes.add("metals that mirror lights alone here, being rough, in part no metal, textured or shining",
                material.metalness() > 0 && !isMirror ? 1 : 0);
        return isMirror ? material.withReflective(material.base()) : material;
    }

    /** With what is seen through it, which the base color tints once at each surface. */
    private Material withTransmission(Material material, GltfMaterial m) {
        var transmission = new TransmissionImport(assembler);
        GltfMaterial.Transmission glass = m.transmission();
        if (!(glass.factor() > 0)) {
            return transmission.withOpacity(material, SceneAssembler.clamp(m.opacity(), 1));
        }
        assembler.notes.add("materials that blur what is seen through them, sharp here",
                material.roughness() > MAX_MIRROR_ROUGHNESS ? 1 : 0);
        Material transmissive = transmission.withTransmission(material, SceneAssembler.clamp(glass.factor(), 1), material.base(),
                glass.ior(), glass.isThin(), material.metalness());
        double distance = glass.tintDistance();
        return glass.isThin() || !(distance <= SceneLimits.MAX_TINT_DISTANCE) ? transmissive
                : transmissive
                        .withTransmission(transmissive.transmission().withTint(assembler.clampColor(glass.tint(), 1, "colors of bodies"))
                                .withTintDistance(Math.max(distance, SceneLimits.MIN_TINT_DISTANCE)));
    }

    /** The mean of what the emission's picture says: a factor alone would make all of the surface glow. Black where it cannot be read. */
    private Rgb emissionTextureMean(GltfMaterial m) throws IOException, MeshException {
        if (m.emissionImage().isEmpty()) {
            return Rgb.WHITE;
        }
        int image = m.emissionImage().getAsInt();
        if (!emissionMeans.containsKey(image)) {
            emissionMeans.put(image, image < 0 ? Optional.empty() : TextureMeans.meanColor(file.imageBytes(image)));
        }
        Optional<Rgb> mean = emissionMeans.get(image);
        assembler.notes.add(mean.isEmpty() ? "emissiveTexture of materials" : "emissiveTexture of materials, of which the mean is taken");
        return mean.orElse(Rgb.BLACK);
    }

    /** @param image of roughness and metalness */
    private TextureMeans metallicRoughnessMeans(int image) throws IOException, MeshException {
        TextureMeans cached = textureMeans.get(image);
        if (cached == null) {
            cached = TextureMeans.of(file.imageBytes(image)).orElse(TextureMeans.NONE);
            textureMeans.put(image, cached);
        }
        assembler.notes.add(cached == TextureMeans.NONE ? "metallicRoughnessTexture of materials"
                : "metallicRoughnessTexture of materials, of which the mean is taken");
        return cached;
    }

    private Optional<TextureMap> textureMap(int image) throws IOException, MeshException {
        if (image >= 0 && !images.containsKey(image)) {
            images.put(image, importImage(image));
        }
        return image < 0 ? Optional.empty() : images.get(image).flatMap(SceneAssembler::placeholderTexture);
    }

    private Material withNormalMap(Material material, GltfMaterial m) throws IOException, MeshException {
        Optional<TextureMap> normals = textureMap(m.normalImage());
        return normals.isEmpty() ? material : material.withBumpMapping(BumpMapping.NONE.withNormalMap(normals)
                .withStrength(Math.clamp(m.normalScale(), -SceneLimits.MAX_STRENGTH, SceneLimits.MAX_STRENGTH)));
    }

    /** Without what the picture's alpha says is not there. */
    private Material withCutout(Material material, GltfMaterial m) throws IOException, MeshException {
        if (!(m.cutoff() > 0) || material.texture().isEmpty() || !TextureDecoder.hasAlpha(file.imageBytes(m.baseImage()))) {
            assembler.notes.add("materials that are not there by their cut-off, shown here", m.cutoff() > m.alphaFactor() ? 1 : 0);
            return material;
        }
        assembler.notes.add("pictures that fade out, cut out here where half of them is there", m.isBlended() ? 1 : 0);
        return material.withCutout(new AlphaCutout(material.texture(), Math.min(m.cutoff() / m.alphaFactor(), 1)));
    }

    /** The name of an image's file; empty where it is none that can be shown. */
    private Optional<String> importImage(int image) throws IOException, MeshException {
        Optional<Path> path = file.imageFile(image);
        if (path.isPresent()) {
            if (SceneAssembler.isPngOrJpeg(path.get())) {
                return Optional.of(assembler.addFile(path.get()));
            }
        } else {
            byte[] bytes = file.imageBytes(image);
            if (SceneAssembler.isPngOrJpeg(bytes)) {
                String name = file.imageName(image);
                String stem = meshFile.replaceFirst("\\.[^.]*$", "") + "-" + (name.isEmpty() ? "image" + image : name);
                return Optional.of(assembler.addFile(stem + (bytes[1] == 'P' ? ".png" : ".jpg"), bytes));
            }
        }
        assembler.notes.add("textures that are no PNG or JPEG");
        return Optional.empty();
    }
}
