package lightning.format.exchange.usd;

import java.io.IOException;
import java.util.Optional;
import lightning.format.exchange.assembly.SceneAssembler;
import lightning.format.gltf.JsonValue;
import lightning.format.mesh.MeshException;
import lightning.scene.asset.TextureChannel;
import lightning.scene.asset.TextureMap;
import lightning.scene.asset.TextureUsage;
import lightning.scene.material.Material;
import lightning.scene.material.SurfaceMaps;

/** Converter of numbers with textures, and their means for transparent materials, which have no maps; adds those of roughness and metalness. */
record UsdSurfaceMaps(SceneAssembler assembler, UsdTextures textures) {
    /** A map, with the factor that it multiplies. */
    record FactoredMap(double factor, TextureMap map, Optional<TextureChannel> channel) {}

    /** Returns a number of a surface; its fallback where it has a texture instead. */
    static double number(JsonValue in, String name, double fallback) throws MeshException {
        return hasTexture(in, name) ? fallback : UsdNumbers.tidy(in.get(name).number(fallback));
    }

    static boolean hasTexture(JsonValue in, String name) throws MeshException {
        return in.get("textures").get(name).isPresent();
    }

    /** Returns a number, or the mean of its texture, with a note. */
    double mean(JsonValue in, String name, double fallback) throws IOException, MeshException {
        return mean(in, name, fallback, "transparent materials");
    }

    /** Returns the same. @param kind of materials, for the note */
    double mean(JsonValue in, String name, double fallback, String kind) throws IOException, MeshException {
        if (!hasTexture(in, name)) {
            return number(in, name, fallback);
        }
        JsonValue image = in.get("textures").get(name);
        Optional<Double> mean = textures.mean(image, TextureNumbers.of(image));
        assembler.notes.addNamed(name + " textures of " + (mean.isEmpty() ? "materials" : kind + ", averaged"),
                image.get("name").text().orElse("texture"));
        return mean.map(UsdNumbers::rounded).orElse(fallback);
    }

    /** Adds the maps of an opaque material. */
    Material withMaps(Material material, JsonValue in) throws IOException, MeshException {
        Optional<FactoredMap> roughness = map(in, "roughness");
        // The specular workflow has no metalness.
        Optional<FactoredMap> metalness = in.get("useSpecularWorkflow").number(0) == 1 ? Optional.empty() : map(in, "metallic");
        SurfaceMaps maps = material.surfaceMaps();
        Material mapped = material;
        if (roughness.isPresent()) {
            maps = maps.withRoughness(Optional.of(roughness.get().map))
                    .withRoughnessChannel(roughness.get().channel.orElse(maps.roughnessChannel()));
            mapped = mapped.withRoughness(roughness.get().factor);
        }
        if (metalness.isPresent()) {
            maps = maps.withMetalness(Optional.of(metalness.get().map))
                    .withMetalnessChannel(metalness.get().channel.orElse(maps.metalnessChannel()));
            mapped = mapped.withMetalness(metalness.get().factor);
        }
        return mapped.withSurfaceMaps(maps);
    }

    /** Returns the map of an input; empty without a texture, or with a note if it cannot be used. */
    Optional<FactoredMap> map(JsonValue in, String name) throws IOException, MeshException {
        if (!hasTexture(in, name)) {
            return Optional.empty();
        }
        JsonValue image = in.get("textures").get(name);
        TextureNumbers numbers = TextureNumbers.of(image);
        Optional<FactoredMap> map = numbers.isProduct()
                ? textures.map(image, TextureUsage.DATA).map(m -> new FactoredMap(numbers.scale(), m, Optional.of(numbers.mapChannel())))
                : textures.numbers(image, numbers, name).map(m -> new FactoredMap(1, m, Optional.empty()));
        assembler.notes.add(name + " textures of materials", map.isEmpty() ? 1 : 0);
        return map;
    }
}
