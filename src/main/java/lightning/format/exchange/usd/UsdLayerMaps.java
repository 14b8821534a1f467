package lightning.format.exchange.usd;

import java.io.IOException;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.format.exchange.assembly.PrincipledImport;
import lightning.format.exchange.assembly.SceneAssembler;
import lightning.format.gltf.JsonValue;
import lightning.format.mesh.MeshException;
import lightning.scene.asset.TextureMap;
import lightning.scene.asset.TextureUsage;
import lightning.scene.material.LayerMaps;
import lightning.scene.material.Material;
import lightning.scene.material.SurfaceMaps;

/**
 * Converter of reflectance, coat and sheen with their textures.
 *
 * @param colors  converter of colors
 * @param isClear whether the material has no maps, but their means
 */
record UsdLayerMaps(SceneAssembler assembler, UsdTextures textures, UsdSurfaceMaps numbers, UsdMaterialImport colors, boolean isClear) {

    /** Sets the reflectance of a nonmetal. */
    Material withHighlights(Material material, JsonValue in) throws IOException, MeshException {
        boolean isSpecular = in.get("useSpecularWorkflow").number(0) == 1;
        double f0 = isSpecular ? 1 : UsdNumbers.rounded(PrincipledImport.f0(in.get("ior").number(1.5)));
        String name = isSpecular ? "specularColor" : "specularTint";
        Optional<TextureMap> map = colorMap(in, name);
        Optional<UsdSurfaceMaps.FactoredMap> level = isSpecular || isClear ? Optional.empty() : numbers.map(in, "specular");
        double factor = level.map(UsdSurfaceMaps.FactoredMap::factor).orElse(1.0);
        Material surface = isSpecular ? material.withMetalness(0) : material;
        var principled = new PrincipledImport(assembler);
        Material reflecting = map.isPresent() ? principled.withReflectance(surface, colors.factor(image(in, name)).times(f0 * factor))
                : isSpecular || in.get(name).isPresent() ? principled.withReflectance(surface, colors.color(in.get(name), 1,
                        "specular colors of materials").times(f0 * factor))
                : surface.withF0(f0);
        SurfaceMaps maps = reflecting.surfaceMaps().withSpecularTint(map);
        return reflecting.withSurfaceMaps(level.isEmpty() ? maps
                : maps.withF0(Optional.of(level.get().map())).withF0Channel(level.get().channel().orElse(maps.f0Channel())));
    }

    /** Adds the coat, which has the index of refraction of the surface in a UsdPreviewSurface. */
    Material withCoat(Material material, JsonValue in) throws IOException, MeshException {
        double ior = UsdNumbers.tidy(in.get("clearcoatIor").number(in.get("ior").number(1.5)));
        var principled = new PrincipledImport(assembler);
        if (isClear) {
            return principled.withCoat(material, numbers.mean(in, "clearcoat", 0), numbers.mean(in, "clearcoatRoughness", 0.01), ior);
        }
        Optional<UsdSurfaceMaps.FactoredMap> weight = numbers.map(in, "clearcoat");
        double share = weight.map(UsdSurfaceMaps.FactoredMap::factor).orElse(UsdSurfaceMaps.number(in, "clearcoat", 0));
        Optional<UsdSurfaceMaps.FactoredMap> roughness = share > 0 ? numbers.map(in, "clearcoatRoughness") : Optional.empty();
        Material coated = principled.withCoat(material, share, roughness.map(UsdSurfaceMaps.FactoredMap::factor)
                .orElse(UsdSurfaceMaps.number(in, "clearcoatRoughness", 0.01)), ior);
        LayerMaps maps = coated.layerMaps();
        if (weight.isPresent()) {
            maps = maps.withCoat(Optional.of(weight.get().map())).withCoatChannel(weight.get().channel().orElse(maps.coatChannel()));
        }
        if (roughness.isPresent()) {
            maps = maps.withCoatRoughness(Optional.of(roughness.get().map()))
                    .withCoatRoughnessChannel(roughness.get().channel().orElse(maps.coatRoughnessChannel()));
        }
        JsonValue normal = image(in, "coatNormal");
        Optional<TextureMap> normals = coated.coat().isVisible() ? textures.map(normal, TextureUsage.DATA) : Optional.empty();
        return coated.withLayerMaps(normals.isEmpty() ? maps : maps.withCoatNormal(normals).withCoatStrength(colors.strength(normal)));
    }

    /** Adds the sheen of a MaterialX surface. OpenPBR has the lobe of scenes; a texture of the roughness of another lobe becomes its mean. */
    Material withSheen(Material material, JsonValue in) throws IOException, MeshException {
        if (!in.get("sheenColor").isPresent()) {
            return material;
        }
        Optional<TextureMap> map = colorMap(in, "sheenColor");
        Rgb color = map.isPresent() ? colors.factor(image(in, "sheenColor")) : colors.color(in.get("sheenColor"), 1, "sheen of materials");
        boolean isFuzz = in.get("isFuzz").number(0) == 1;
        Optional<UsdSurfaceMaps.FactoredMap> roughness =
                isFuzz && !isClear && !color.isBlack() ? numbers.map(in, "sheenRoughness") : Optional.empty();
        double number = roughness.isPresent() ? roughness.get().factor()
                : color.isBlack() ? 0 : numbers.mean(in, "sheenRoughness", 0, isClear ? "transparent materials" : "sheens of another lobe");
        Material sheen = new PrincipledImport(assembler).withSheen(material, color,
                isFuzz ? UsdNumbers.tidy(number) : PrincipledImport.sheenRoughness(number));
        LayerMaps maps = sheen.layerMaps().withSheen(map);
        return !sheen.sheen().isVisible() ? sheen
                : sheen.withLayerMaps(roughness.isEmpty() ? maps
                        : maps.withSheenRoughness(Optional.of(roughness.get().map()))
                                .withSheenRoughnessChannel(roughness.get().channel().orElse(maps.sheenRoughnessChannel())));
    }

    /** Returns the map of a color; empty without a texture, or with a note if it cannot be used. */
    private Optional<TextureMap> colorMap(JsonValue in, String name) throws IOException, MeshException {
        JsonValue image = image(in, name);
        Optional<TextureMap> map = isClear ? Optional.empty() : textures.map(image, TextureUsage.COLOR);
        assembler.notes.add(name + " textures of materials", image.isPresent() && map.isEmpty() ? 1 : 0);
        return map;
    }

    private static JsonValue image(JsonValue in, String name) throws MeshException {
        return in.get("textures").get(name);
    }
}
