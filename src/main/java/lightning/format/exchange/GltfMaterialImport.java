package lightning.format.exchange;

import java.io.IOException;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.format.exchange.assembly.PrincipledImport;
import lightning.format.exchange.assembly.SceneAssembler;
import lightning.format.exchange.assembly.TextureMeans;
import lightning.format.exchange.assembly.TransmissionImport;
import lightning.format.gltf.GltfMaterial;
import lightning.format.gltf.GltfScene;
import lightning.format.jen.asset.TextureFile;
import lightning.format.mesh.MeshException;
import lightning.scene.asset.TextureMap;
import lightning.scene.asset.TextureUsage;
import lightning.scene.material.AlphaCutout;
import lightning.scene.material.BumpMapping;
import lightning.scene.material.Material;
import lightning.scene.material.ShadingModel;
import lightning.scene.value.SceneLimits;

/** Converter from glTF materials to principled materials; notes unsupported properties. */
final class GltfMaterialImport {

    private final SceneAssembler assembler;
    private final PrincipledImport principled;
    private final GltfTextures textures;
    private final Map<Integer, TextureMeans> textureMeans = new HashMap<>();

    /**
     * Creates a converter.
     *
     * @param meshFile name of the glTF file next to the scene
     */
    GltfMaterialImport(SceneAssembler assembler, GltfScene file, String meshFile) {
        this.assembler = assembler;
        principled = new PrincipledImport(assembler);
        textures = new GltfTextures(assembler, file, meshFile);
    }

    Material convert(GltfMaterial m) throws IOException, MeshException {
        Rgb base = assembler.clampColor(m.base(), 1, "base colors of materials");
        if (m.isUnlit()) {
            Optional<TextureMap> map = textures.map(m.baseImage(), TextureUsage.COLOR);
            // Ambient light has no map, glow has.
            Material unlit = Material.of("material").withDiffuse(Rgb.BLACK);
            return withCutout(map.isEmpty() ? unlit.withAmbient(base) : unlit.withGlow(base).withGlowMap(map), m);
        }
        TextureMeans means = m.metallicRoughnessImage().isPresent() && (m.transmission().factor() > 0 || m.opacity() < 1)
                ? metallicRoughnessMeans(m.metallicRoughnessImage().index()) : TextureMeans.NONE;
        Material material =
                withGlow(PrincipledImport.material(base, m.metallic() * means.metalness(), m.roughness() * means.roughness()), m)
                        .withTexture(textures.map(m.baseImage(), TextureUsage.COLOR));
        Material surface = withTransmission(withHighlights(material, m), m);
        Material layered = withAnisotropy(withSurfaceMaps(withSheen(withCoat(surface, m), m), m), m);
        return withCutout(withNormalMap(new GltfMapImport(assembler, textures).withMaps(layered, m), m), m);
    }

    /** Adds the maps of roughness and metalness; a transparent material has their means. */
    private Material withSurfaceMaps(Material material, GltfMaterial m) throws IOException, MeshException {
        if (!m.metallicRoughnessImage().isPresent() || material.model() != ShadingModel.PRINCIPLED) {
            return material;
        }
        if (material.isClear()) {
            boolean isRead = metallicRoughnessMeans(m.metallicRoughnessImage().index()) != TextureMeans.NONE;
            assembler.notes.add(isRead ? "metallicRoughnessTexture of materials, averaged" : "metallicRoughnessTexture of materials");
            return material;
        }
        Optional<TextureMap> map = textures.map(m.metallicRoughnessImage(), TextureUsage.DATA);
        assembler.notes.add("metallicRoughnessTexture of materials", map.isEmpty() ? 1 : 0);
        return material.withMetalness(SceneAssembler.clamp(m.metallic(), 1)).withRoughness(SceneAssembler.clamp(m.roughness(), 1))
                .withSurfaceMaps(material.surfaceMaps().withRoughness(map).withMetalness(map.filter(_ -> m.metallic() > 0)));
    }

    /** Adds the reflection of a nonmetal, with full reflection at grazing angles. */
    private Material withHighlights(Material material, GltfMaterial m) {
        if (material.metalness() == 0 && m.f90() == 0 && m.clearcoat().factor() == 0 && m.sheen().color().isBlack()) {
            // Without Fresnel reflection it is matte at all angles, which a principled material is not at grazing ones.
            return material.withModel(ShadingModel.PHONG).withDiffuse(material.base());
        }
        assembler.notes.add("grazing-angle specular below 1 (specularFactor), imported as 1",
                material.metalness() < 1 && (m.f90() != 1 || !m.specular().keepsGrazing()) ? 1 : 0);
        return principled.withReflectance(material, m.f0());
    }

    private Material withCoat(Material material, GltfMaterial m) {
        return principled.withCoat(material, m.clearcoat().factor(), m.clearcoat().roughness(), m.clearcoat().ior());
    }

    private Material withSheen(Material material, GltfMaterial m) {
        GltfMaterial.Sheen sheen = m.sheen();
        return principled.withSheen(material, sheen.color(),
                sheen.exactRoughness().orElseGet(() -> PrincipledImport.sheenRoughness(sheen.roughness())));
    }

    /**
     * Adds the anisotropy. The extension's widths are α across the direction, and along it a mix of α and 1; the extras of a file may have an
     * anisotropy of scenes.
     */
    private Material withAnisotropy(Material material, GltfMaterial m) {
        GltfMaterial.Anisotropy anisotropy = m.anisotropy();
        if (material.model() != ShadingModel.PRINCIPLED || anisotropy.strength() == 0 && anisotropy.exactStrength().isEmpty()) {
            return material;
        }
        if (anisotropy.exactStrength().isPresent()) {
            double strength = SceneAssembler.clamp(anisotropy.exactStrength().getAsDouble(), 1);
            return principled.withBurleyAnisotropy(material, strength, Math.toDegrees(anisotropy.rotation()));
        }
        double alpha = Material.alpha(material.meanRoughness());
        double square = SceneAssembler.clamp(anisotropy.strength(), 1) * SceneAssembler.clamp(anisotropy.strength(), 1);
        return principled.withAnisotropy(material, (alpha + (1 - alpha) * square) / alpha, 1, Math.toDegrees(anisotropy.rotation()));
    }

    /** Adds transmission; the base color tints the light once at each surface. */
    private Material withTransmission(Material material, GltfMaterial m) {
        var transmission = new TransmissionImport(assembler);
        GltfMaterial.Transmission glass = m.transmission();
        if (!(glass.factor() > 0)) {
            return transmission.withOpacity(material, SceneAssembler.clamp(m.opacity(), 1));
        }
        assembler.notes.add("transparent materials without a volume (KHR_materials_volume), imported as thin sheets",
                glass.isThin() ? 1 : 0);
        Material transmissive = transmission.withTransmission(material, SceneAssembler.clamp(glass.factor(), 1), material.base(),
                glass.ior(), glass.isThin(), material.metalness());
        double distance = glass.tintDistance();
        return glass.isThin() || !(distance <= SceneLimits.MAX_TINT_DISTANCE) ? transmissive
                : transmissive
                        .withTransmission(transmissive.transmission().withTint(assembler.clampColor(glass.tint(), 1, "colors of bodies"))
                                .withTintDistance(Math.max(distance, SceneLimits.MIN_TINT_DISTANCE)));
    }

    /** Adds the emission. Without its texture nothing glows, since the factor alone would make the whole surface emit. */
    private Material withGlow(Material material, GltfMaterial m) throws IOException, MeshException {
        Rgb glow = assembler.clampColor(m.emission(), SceneLimits.MAX_EMISSION, "emission of materials");
        if (glow.isBlack() || m.emissionImage().isEmpty()) {
            return material.withGlow(glow);
        }
        Optional<TextureMap> map = textures.map(m.emissionImage().get(), TextureUsage.COLOR);
        assembler.notes.add("emissiveTexture of materials", map.isEmpty() ? 1 : 0);
        return map.isEmpty() ? material : material.withGlow(glow).withGlowMap(map);
    }

    /**
     * Returns the mean roughness and metalness.
     *
     * @param image index of the metallic-roughness image
     */
    private TextureMeans metallicRoughnessMeans(int image) throws IOException, MeshException {
        TextureMeans cached = textureMeans.get(image);
        if (cached == null) {
            cached = textures.bytes(image).flatMap(TextureMeans::of).orElse(TextureMeans.NONE);
            textureMeans.put(image, cached);
        }
        return cached;
    }

    private Material withNormalMap(Material material, GltfMaterial m) throws IOException, MeshException {
        Optional<TextureMap> normals = textures.map(m.normalImage(), TextureUsage.DATA);
        return normals.isEmpty() ? material : material.withBumpMapping(BumpMapping.NONE.withNormalMap(normals)
                .withStrength(Math.clamp(m.normalScale(), -SceneLimits.MAX_STRENGTH, SceneLimits.MAX_STRENGTH)));
    }

    /** Adds an opacity map from the texture's alpha. */
    private Material withCutout(Material material, GltfMaterial m) throws IOException, MeshException {
        Optional<TextureMap> opacity =
                m.cutoff() > 0 && m.baseImage().isPresent()
                        && textures.bytes(m.baseImage().index()).filter(TextureFile::hasAlpha).isPresent()
                                ? textures.map(m.baseImage(), TextureUsage.OPACITY) : Optional.empty();
        if (opacity.isEmpty()) {
            assembler.notes.add("materials invisible by their alpha cutoff, imported as visible", m.cutoff() > m.alphaFactor() ? 1 : 0);
            return material;
        }
        assembler.notes.add("alpha-blended textures, imported as cutouts at half opacity", m.isBlended() ? 1 : 0);
        return material.withCutout(new AlphaCutout(opacity, Math.min(m.cutoff() / m.alphaFactor(), 1)));
    }
}
