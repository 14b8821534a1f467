package lightning.format.exchange.usd;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.format.exchange.assembly.PrincipledImport;
import lightning.format.exchange.assembly.SceneAssembler;
import lightning.format.exchange.assembly.TransmissionImport;
import lightning.format.gltf.JsonValue;
import lightning.format.mesh.MeshException;
import lightning.scene.asset.TextureMap;
import lightning.scene.asset.TextureUsage;
import lightning.scene.material.AlphaCutout;
import lightning.scene.material.BumpMapping;
import lightning.scene.material.Material;
import lightning.scene.value.SceneLimits;

/** Converter from UsdPreviewSurface to principled materials. */
record UsdMaterialImport(SceneAssembler assembler, UsdTextures textures) {
    /** Inputs whose textures the scene shows, besides the emission. */
    private static final List<String> MAPPED =
            List.of("diffuseColor", "normal", "opacity", "roughness", "metallic", "coatNormal", "clearcoat",
                    "clearcoatRoughness", "specular", "specularColor", "specularTint", "sheenColor", "sheenRoughness");
    /** Inputs whose textures are left out. */
    private static final List<String> UNMAPPED = List.of("ior");
    private static final double HALF = 0.5;
    /** Degrees of a turn. */
    private static final double TURN = 360;
    /** Largest anisotropy of a standard surface (MaterialX, roughness_anisotropy). */
    private static final double STANDARD_LIMIT = 0.98;

    Material convert(JsonValue in) throws IOException, MeshException {
        if (in.get("display").isPresent()) {
            Material plain = Material.of("material").withDiffuse(color(in.get("display"), 1, "display colors"));
            return new TransmissionImport(assembler).withOpacity(plain, SceneAssembler.clamp(in.get("opacity").number(1), 1));
        }
        JsonValue images = in.get("textures");
        JsonValue baseImage = images.get("diffuseColor");
        Optional<TextureMap> texture = textures.map(baseImage, TextureUsage.COLOR);
        Rgb base = texture.isPresent() ? factor(baseImage) : color(in.get("diffuseColor"), 1, "colors of materials");
        var surfaceMaps = new UsdSurfaceMaps(assembler, textures);
        boolean isClear = mayTransmit(in);
        Material material = PrincipledImport.material(base,
                isClear ? surfaceMaps.mean(in, "metallic", 0) : UsdSurfaceMaps.number(in, "metallic", 0),
                isClear ? surfaceMaps.mean(in, "roughness", HALF) : UsdSurfaceMaps.number(in, "roughness", HALF)).withTexture(texture);
        noteLosses(in);
        var layers = new UsdLayerMaps(assembler, textures, surfaceMaps, this, isClear);
        Material surface = withOpacity(withNormals(layers.withHighlights(withGlow(material, in), in), images.get("normal")), in);
        return withAnisotropy(layers.withSheen(layers.withCoat(isClear ? surface : surfaceMaps.withMaps(surface, in), in), in), in);
    }

    /** Returns whether a material is transparent, unless it is metal. */
    private static boolean mayTransmit(JsonValue in) throws MeshException {
        return !in.get("textures").get("opacity").isPresent()
                && (in.get("transmission").number(0) > 0 || in.get("opacityThreshold").number(0) <= 0 && in.get("opacity").number(1) < 1);
    }

    /** Returns the textures of a material that the scene shows. */
    List<JsonValue> maps(JsonValue in) throws MeshException {
        JsonValue images = in.get("textures");
        List<JsonValue> maps = new ArrayList<>();
        for (String input : MAPPED) {
            if (images.get(input).isPresent()) {
                maps.add(images.get(input));
            }
        }
        JsonValue emission = images.get("emissiveColor");
        if (!textures.hasHighRange(emission)) {
            maps.add(emission);
        }
        return maps;
    }

    private void noteLosses(JsonValue in) throws MeshException {
        for (String input : UNMAPPED) {
            assembler.notes.add(input + " textures of materials", in.get("textures").get(input).isPresent() ? 1 : 0);
        }
        assembler.notes.add("displacement of materials",
                in.get("displacement").number(0) != 0 || in.get("textures").get("displacement").isPresent() ? 1 : 0);
    }

    /** Adds the anisotropy of a MaterialX surface by its own widths: α of the roughness in terms of them. */
    private Material withAnisotropy(Material material, JsonValue in) throws MeshException {
        double a = SceneAssembler.clamp(in.get("anisotropy").number(0), 1);
        if (a == 0) {
            return material;
        }
        double rotation = in.get("anisotropyRotation").number(0);
        var principled = new PrincipledImport(assembler);
        double alpha = Material.alpha(material.meanRoughness());
        return switch (in.get("surface").text().orElse("")) {
            // The mean square of both widths is α².
            case "open_pbr_surface" -> {
                double along = Math.sqrt(2 / (1 + (1 - a) * (1 - a)));
                yield principled.withAnisotropy(material, along, along * (1 - a), TURN * rotation);
            }
            case "gltf_pbr" -> principled.withAnisotropy(material, (alpha + (1 - alpha) * a * a) / alpha, 1, Math.toDegrees(rotation));
            default -> {
                double aspect = Math.sqrt(1 - Math.min(a, STANDARD_LIMIT));
                yield principled.withAnisotropy(material, 1 / aspect, aspect, TURN * rotation);
            }
        };
    }

    private Material withNormals(Material material, JsonValue image) throws IOException, MeshException {
        Optional<TextureMap> normals = textures.map(image, TextureUsage.DATA);
        return normals.isEmpty() ? material
                : material.withBumpMapping(BumpMapping.NONE.withNormalMap(normals).withStrength(strength(image)));
    }

    /** Returns the strength of a normal map. */
    double strength(JsonValue image) throws MeshException {
        double[] scale = image.get("scale").numbers(2, 2, 2, 1);
        double strength = image.get("strength").number(scale[0] == 1 ? 1 : scale[0] / 2);
        // A scale of 2 and a bias of −1 decode 0 … 1 to −1 … 1.
        assembler.notes.add("normal maps with y downwards", scale[0] * scale[1] < 0 ? 1 : 0);
        return Math.clamp(UsdNumbers.tidy(strength), -SceneLimits.MAX_STRENGTH, SceneLimits.MAX_STRENGTH);
    }

    private Material withOpacity(Material material, JsonValue in) throws IOException, MeshException {
        double threshold = in.get("opacityThreshold").number(0);
        JsonValue image = in.get("textures").get("opacity");
        if (image.isPresent()) {
            TextureNumbers numbers = TextureNumbers.of(image);
            if (textures.isOpaque(image, numbers)) {
                return material;
            }
            Optional<TextureMap> map = textures.opacity(image, numbers);
            assembler.notes.add("opacity maps, imported as cutouts at half opacity", map.isPresent() && threshold <= 0 ? 1 : 0);
            return material.withCutout(new AlphaCutout(map, threshold > 0 ? SceneAssembler.clamp(threshold, 1) : HALF));
        }
        double opacity = SceneAssembler.clamp(in.get("opacity").number(1), 1);
        var transmission = new TransmissionImport(assembler);
        double transmitted = in.get("transmission").number(0);
        if (transmitted > 0) {
            return transmission.withTransmission(material, SceneAssembler.clamp(transmitted, 1), material.base(),
                    UsdNumbers.tidy(in.get("ior").number(1.5)),
                    false, material.metalness());
        }
        if (threshold > 0) {
            assembler.notes.add("materials invisible by their opacity threshold, imported as visible", opacity < threshold ? 1 : 0);
            return material;
        }
        return transmission.withOpacity(material, opacity);
    }

    /** Adds the emission. A texture whose values may exceed 1 becomes its mean, because glow maps are limited to 1. */
    private Material withGlow(Material material, JsonValue in) throws IOException, MeshException {
        JsonValue image = in.get("textures").get("emissiveColor");
        if (!image.isPresent()) {
            return material.withGlow(color(in.get("emissiveColor"), SceneLimits.MAX_EMISSION, "emission of materials"));
        }
        Rgb factor = scale(image);
        if (factor.isBlack()) {
            return material;
        }
        if (textures.hasHighRange(image)) {
            assembler.notes.add("OpenEXR textures of emission, averaged");
            return material.withGlow(textures.mean(image, TextureUsage.COLOR)
                    .map(mean -> emission(new Rgb(mean[0] * factor.r(), mean[1] * factor.g(), mean[2] * factor.b()))).orElse(Rgb.BLACK));
        }
        Optional<TextureMap> map = textures.map(image, TextureUsage.COLOR);
        return map.isEmpty() ? material : material.withGlow(emission(factor)).withGlowMap(map);
    }

    private Rgb emission(Rgb color) {
        return assembler.clampColor(color, SceneLimits.MAX_EMISSION, "emission of materials");
    }

    /** Returns the factor of a color texture. */
    Rgb factor(JsonValue image) throws MeshException {
        double[] bias = image.get("bias").numbers(0, 0, 0, 0);
        assembler.notes.add("offsets (bias) of color textures", bias[0] == 0 && bias[1] == 0 && bias[2] == 0 ? 0 : 1);
        return assembler.clampColor(scale(image), 1, "scales of color textures");
    }

    private static Rgb scale(JsonValue image) throws MeshException {
        double[] scale = image.get("scale").numbers(1, 1, 1, 1);
        return new Rgb(UsdNumbers.tidy(scale[0]), UsdNumbers.tidy(scale[1]), UsdNumbers.tidy(scale[2]));
    }

    /** Returns a color, clamped with a note. */
    Rgb color(JsonValue in, double max, String label) throws MeshException {
        return assembler.clampColor(rgb(in), max, label);
    }

    private static Rgb rgb(JsonValue in) throws MeshException {
        double[] c = in.numbers(0, 0, 0);
        return new Rgb(UsdNumbers.tidy(c[0]), UsdNumbers.tidy(c[1]), UsdNumbers.tidy(c[2]));
    }
}
