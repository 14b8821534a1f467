package lightning.format.gltf;

import java.util.Optional;
import java.util.OptionalDouble;
import lightning.base.math.Affine2;
import lightning.base.math.Rgb;
import lightning.format.mesh.ConversionNotes;
import lightning.format.mesh.MeshException;
import lightning.scene.asset.TextureWrap;

/**
 * Reader for the materials of a glTF file.
 *
 * @param notes receives omitted features
 */
record MaterialReader(GltfFile file, ConversionNotes notes) {
    private static final int REPEAT = 10497;
    private static final int CLAMP = 33071;
    private static final int MIRROR = 33648;
    private static final int NEAREST = 9728;
    private static final double DEFAULT_CUTOFF = 0.5;

    GltfMaterial material(JsonValue material) throws MeshException {
        JsonValue pbr = material.get("pbrMetallicRoughness");
        JsonValue extensions = material.get("extensions");
        notes.add("occlusionTexture of materials", material.get("occlusionTexture").isPresent() ? 1 : 0);
        String alpha = material.get("alphaMode").text().orElse("OPAQUE");
        double alphaFactor = pbr.get("baseColorFactor").numbers(1, 1, 1, 1)[3];
        double opacity = alpha.equals("BLEND") ? alphaFactor : 1;
        boolean isBlended = alpha.equals("BLEND") && opacity == 1;
        double cutoff = alpha.equals("MASK") ? material.get("alphaCutoff").number(DEFAULT_CUTOFF) : isBlended ? DEFAULT_CUTOFF : 0;
        double[] emission = material.get("emissiveFactor").numbers(0, 0, 0);
        double strength = extensions.get("KHR_materials_emissive_strength").get("emissiveStrength").number(1);
        JsonValue normals = material.get("normalTexture");
        JsonValue emissive = material.get("emissiveTexture");
        GltfMaterial.Transmission transmission = readTransmission(extensions);
        notePlacement(material, normals, "normalTexture of materials with other texture coordinates than baseColorTexture, placed like it");
        notePlacement(material, emissive, "emissiveTexture of materials with texture coordinates of its own, placed like other textures");
        if (opacity == 1 && transmission.factor() == 0) {
            notePlacement(material, pbr.get("metallicRoughnessTexture"),
                    "metallicRoughnessTexture of materials with texture coordinates of its own, placed like other textures");
        }
        noteMissing(material);
        JsonValue glossy = extensions.get("KHR_materials_pbrSpecularGlossiness");
        Surface surface =
                glossy.isPresent() && !pbr.isPresent() ? glossySurface(material, glossy) : metallicSurface(material, pbr, extensions);
        return new GltfMaterial(material.get("name").text().orElse(""), surface.base, surface.metallic, surface.roughness,
                surface.f0, surface.f90, surface.specular, new Rgb(emission[0], emission[1], emission[2]).times(strength),
                emissive.isPresent() ? Optional.of(textureImage(material, emissive)) : Optional.empty(),
                extensions.get("KHR_materials_unlit").isPresent(), surface.baseImage, surface.metallicRoughnessImage,
                textureImage(material, normals),
                normals.get("scale").number(1), opacity, transmission, readClearcoat(material, extensions), readSheen(material, extensions),
                readAnisotropy(extensions), cutoff,
                alphaFactor,
                isBlended);
    }

    private void notePlacement(JsonValue material, JsonValue texture, String note) throws MeshException {
        notes.add(note, texture.isPresent() && TextureTransform.relative(material, texture).isEmpty() ? 1 : 0);
    }

    /** Notes the properties that no material of a scene has, with the name of the material. */
    private void noteMissing(JsonValue material) throws MeshException {
        JsonValue extensions = material.get("extensions");
        noteMissing(material, "iridescence", extensions.get("KHR_materials_iridescence").get("iridescenceFactor").number(0));
        noteMissing(material, "dispersion", extensions.get("KHR_materials_dispersion").get("dispersion").number(0));
        noteMissing(material, "diffuse transmission",
                extensions.get("KHR_materials_diffuse_transmission").get("diffuseTransmissionFactor").number(0));
    }

    private void noteMissing(JsonValue material, String property, double factor) throws MeshException {
        if (factor != 0) {
            notes.addNamed(property + " of materials", material.get("name").text().orElse("unnamed"));
        }
    }

    private GltfMaterial.Clearcoat readClearcoat(JsonValue material, JsonValue extensions) throws MeshException {
        JsonValue coat = extensions.get("KHR_materials_clearcoat");
        return new GltfMaterial.Clearcoat(coat.get("clearcoatFactor").number(0), placedImage(material, coat, "clearcoatTexture"),
                coat.get("clearcoatRoughnessFactor").number(0), placedImage(material, coat, "clearcoatRoughnessTexture"),
                placedImage(material, coat, "clearcoatNormalTexture"), coat.get("clearcoatNormalTexture").get("scale").number(1),
                coat.get("extras").get("ior").number(GltfMaterial.Clearcoat.DEFAULT_IOR));
    }

    private GltfMaterial.Sheen readSheen(JsonValue material, JsonValue extensions) throws MeshException {
        JsonValue sheen = extensions.get("KHR_materials_sheen");
        double[] color = sheen.get("sheenColorFactor").numbers(0, 0, 0);
        JsonValue exact = sheen.get("extras").get("roughness");
        return new GltfMaterial.Sheen(new Rgb(color[0], color[1], color[2]), placedImage(material, sheen, "sheenColorTexture"),
                sheen.get("sheenRoughnessFactor").number(0), placedImage(material, sheen, "sheenRoughnessTexture"),
                exact.isPresent() ? OptionalDouble.of(exact.number(0)) : OptionalDouble.empty());
    }

    private GltfMaterial.Anisotropy readAnisotropy(JsonValue extensions) throws MeshException {
        JsonValue anisotropy = extensions.get("KHR_materials_anisotropy");
        notes.add("anisotropyTexture of materials", anisotropy.get("anisotropyTexture").isPresent() ? 1 : 0);
        JsonValue exact = anisotropy.get("extras").get("anisotropy");
        return new GltfMaterial.Anisotropy(anisotropy.get("anisotropyStrength").number(0), anisotropy.get("anisotropyRotation").number(0),
                exact.isPresent() ? OptionalDouble.of(exact.number(0)) : OptionalDouble.empty());
    }

    /** Returns the index of refraction of KHR_materials_ior. */
    private static double ior(JsonValue extensions) throws MeshException {
        return extensions.get("KHR_materials_ior").get("ior").number(1.5);
    }

    /** Reads KHR_materials_transmission with KHR_materials_ior and KHR_materials_volume. */
    private GltfMaterial.Transmission readTransmission(JsonValue extensions) throws MeshException {
        JsonValue transmission = extensions.get("KHR_materials_transmission");
        JsonValue volume = extensions.get("KHR_materials_volume");
        notes.add("transmissionTexture of materials", transmission.get("transmissionTexture").isPresent() ? 1 : 0);
        notes.add("thicknessTexture of materials", volume.get("thicknessTexture").isPresent() ? 1 : 0);
        double[] tint = volume.get("attenuationColor").numbers(1, 1, 1);
        return new GltfMaterial.Transmission(transmission.get("transmissionFactor").number(0),
                ior(extensions), volume.get("thicknessFactor").number(0) == 0,
                new Rgb(tint[0], tint[1], tint[2]), volume.get("attenuationDistance").number(Double.POSITIVE_INFINITY));
    }

    /** Reflection properties of a material, as in {@link GltfMaterial}. */
    private record Surface(Rgb base, GltfImage baseImage, double metallic, double roughness,
            GltfImage metallicRoughnessImage, Rgb f0, double f90, GltfMaterial.Specular specular) {}

    /**
     * Reads the metallic-roughness model: appendix B of glTF 2.0; KHR_materials_ior; KHR_materials_specular, which clamps
     * the tinted F0 before scaling.
     */
    private Surface metallicSurface(JsonValue material, JsonValue pbr, JsonValue extensions) throws MeshException {
        double[] base = pbr.get("baseColorFactor").numbers(1, 1, 1, 1);
        double ior = ior(extensions);
        JsonValue specular = extensions.get("KHR_materials_specular");
        double[] tint = specular.get("specularColorFactor").numbers(1, 1, 1);
        double weight = specular.get("specularFactor").number(1);
        double f0 = (ior - 1) * (ior - 1) / ((ior + 1) * (ior + 1));
        return new Surface(new Rgb(base[0], base[1], base[2]), textureImage(material, pbr.get("baseColorTexture")),
                pbr.get("metallicFactor").number(1), pbr.get("roughnessFactor").number(1),
                textureImage(material, pbr.get("metallicRoughnessTexture")), new Rgb(Math.min(f0 * tint[0], 1) * weight,
                        Math.min(f0 * tint[1], 1) * weight, Math.min(f0 * tint[2], 1) * weight),
                weight, new GltfMaterial.Specular(placedImage(material, specular, "specularTexture"),
                        !specular.get("specularTexture").isPresent() || specular.get("extras").get("level").number(0) == 1,
                        placedImage(material, specular, "specularColorTexture")));
    }

    /** Reads the older specular-glossiness model, in which nothing is metallic; its use is noted as an extension. */
    private Surface glossySurface(JsonValue material, JsonValue glossiness) throws MeshException {
        double[] diffuse = glossiness.get("diffuseFactor").numbers(1, 1, 1, 1);
        double[] specular = glossiness.get("specularFactor").numbers(1, 1, 1);
        boolean hasTexture = glossiness.get("specularGlossinessTexture").isPresent();
        notes.add("specularGlossinessTexture of materials", hasTexture ? 1 : 0);
        // The factor multiplied by such an image is not meaningful alone: most files use 1.
        return new Surface(new Rgb(diffuse[0], diffuse[1], diffuse[2]), textureImage(material, glossiness.get("diffuseTexture")), 0,
                hasTexture ? 0.5 : 1 - glossiness.get("glossinessFactor").number(1), GltfImage.NONE,
                hasTexture ? Rgb.gray(0.04) : new Rgb(specular[0], specular[1], specular[2]), 1,
                GltfMaterial.Specular.NONE);
    }

    /** Returns the image of a texture of an extension; notes one with texture coordinates of its own. */
    private GltfImage placedImage(JsonValue material, JsonValue extension, String texture) throws MeshException {
        notePlacement(material, extension.get(texture),
                texture + " of materials with texture coordinates of its own, placed like other textures");
        return textureImage(material, extension.get(texture));
    }

    private GltfImage textureImage(JsonValue material, JsonValue texture) throws MeshException {
        return new GltfImage(imageIndex(texture), wrap(texture), TextureTransform.relative(material, texture).orElse(Affine2.IDENTITY));
    }

    /** Returns what follows the edges of a texture's image. */
    private TextureWrap wrap(JsonValue texture) {
        try {
            JsonValue index = texture.isPresent() ? texture.get("index").resolve(file.array("textures")).get("sampler") : texture;
            if (!index.isPresent()) {
                return TextureWrap.REPEAT;
            }
            JsonValue sampler = index.resolve(file.array("samplers"));
            notes.add("unfiltered textures, imported as filtered",
                    sampler.get("magFilter").integer(0, Integer.MAX_VALUE, 0) == NEAREST ? 1 : 0);
            return new TextureWrap(edge(sampler.get("wrapS")), edge(sampler.get("wrapT")));
        } catch (MeshException e) {
            // An invalid texture is noted with the image.
            return TextureWrap.REPEAT;
        }
    }

    private TextureWrap.Edge edge(JsonValue mode) throws MeshException {
        return switch (mode.integer(0, Integer.MAX_VALUE, REPEAT)) {
            case CLAMP -> TextureWrap.Edge.CLAMP;
            case MIRROR -> TextureWrap.Edge.MIRROR;
            default -> TextureWrap.Edge.REPEAT;
        };
    }

    /** Returns the index of a texture's image; −1 for none, and with a note for one that is invalid. */
    private int imageIndex(JsonValue texture) {
        try {
            return texture.isPresent() ? validIndex(texture) : -1;
        } catch (MeshException e) {
            notes.add("textures with invalid references");
            return -1;
        }
    }

    private int validIndex(JsonValue texture) throws MeshException {
        JsonValue entry = texture.get("index").resolve(file.array("textures"));
        JsonValue webp = entry.get("extensions").get("EXT_texture_webp").get("source");
        JsonValue source = entry.get("source").isPresent() ? entry.get("source") : webp;
        if (!source.isPresent()) {
            notes.add("textures in formats of extensions, such as KTX2, which gltf-transform ktxdecompress unpacks");
            return -1;
        }
        return source.index(file.array("images"));
    }
}
