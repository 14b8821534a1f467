package lightning.format.gltf;

import java.util.Optional;
import java.util.stream.Stream;
import lightning.base.math.Affine2;
import lightning.format.mesh.MeshException;

/**
 * Texture coordinate set and transform (KHR_texture_transform) of a material's base color image; if there is none, of its normal map, of its
 * emission image, of its metallic-roughness image, or of an extension.
 *
 * @param set index of the primitive's texture coordinates
 * @param map of coordinates whose v points down
 */
record TextureTransform(int set, Affine2 map) {
    static TextureTransform of(GltfFile file, int material) {
        if (material < 0) {
            return new TextureTransform(0, Affine2.IDENTITY);
        }
        try {
            return ofMaterial(file.array("materials").element(material));
        } catch (MeshException e) {
            // The reader of the materials notes it.
            return new TextureTransform(0, Affine2.IDENTITY);
        }
    }

    private static TextureTransform ofMaterial(JsonValue json) throws MeshException {
        return of(placingTexture(json));
    }

    /** Returns whether a material has an image that is placed. */
    static boolean hasTexture(GltfFile file, int material) throws MeshException {
        return placingTexture(file.array("materials").element(material)).isPresent();
    }

    /** Returns the texture of a material whose placement all of its textures share here; an absent value without textures. */
    static JsonValue placingTexture(JsonValue material) throws MeshException {
        JsonValue pbr = material.get("pbrMetallicRoughness");
        JsonValue extensions = material.get("extensions");
        JsonValue coat = extensions.get("KHR_materials_clearcoat");
        JsonValue specular = extensions.get("KHR_materials_specular");
        JsonValue sheen = extensions.get("KHR_materials_sheen");
        return Stream.of(pbr.get("baseColorTexture"), material.get("normalTexture"), material.get("emissiveTexture"),
                pbr.get("metallicRoughnessTexture"), coat.get("clearcoatTexture"), coat.get("clearcoatRoughnessTexture"),
                coat.get("clearcoatNormalTexture"),
                specular.get("specularTexture"), specular.get("specularColorTexture"), sheen.get("sheenColorTexture"))
                .filter(JsonValue::isPresent).findFirst().orElse(sheen.get("sheenRoughnessTexture"));
    }

    /** Returns whether two placements are the same. */
    boolean isSame(TextureTransform other) {
        return set == other.set && map.equals(other.map);
    }

    private static TextureTransform of(JsonValue texture) throws MeshException {
        JsonValue transform = texture.get("extensions").get("KHR_texture_transform");
        int set = transform.get("texCoord").integer(0, 100, texture.get("texCoord").integer(0, 100, 0));
        double[] offset = transform.get("offset").numbers(0, 0);
        double[] scale = transform.get("scale").numbers(1, 1);
        double angle = transform.get("rotation").number(0);
        double c = Math.cos(angle);
        double s = Math.sin(angle);
        // Translation · rotation · scale; the extension rotates with v pointing down.
        return new TextureTransform(set, new Affine2(c * scale[0], s * scale[1], offset[0], -s * scale[0], c * scale[1], offset[1]));
    }

    /**
     * Returns the map from the coordinates of a material's meshes here, whose v points up, to those of one of its textures; empty if there is none, because
     * the texture has other coordinates.
     */
    static Optional<Affine2> relative(JsonValue material, JsonValue texture) throws MeshException {
        TextureTransform shared = ofMaterial(material);
        TextureTransform own = of(texture);
        return own.isSame(shared) ? Optional.of(Affine2.IDENTITY) : own.set != shared.set ? Optional.empty()
                : shared.map.inverse().map(back -> Affine2.FLIP.times(own.map).times(back).times(Affine2.FLIP));
    }

    /** Transforms glTF coordinates, whose v points down, to coordinates whose v points up. */
    void apply(float[] coordinates) {
        for (int i = 0; i < coordinates.length; i += 2) {
            double u = coordinates[i];
            double v = coordinates[i + 1];
            coordinates[i] = (float) map.u(u, v);
            coordinates[i + 1] = (float) (1 - map.v(u, v));
        }
    }
}
