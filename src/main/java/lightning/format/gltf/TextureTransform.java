package lightning.format.gltf;

import java.util.Arrays;
import java.util.stream.Stream;
import lightning.format.mesh.MeshException;

/**
 * Texture coordinate set and transform (KHR_texture_transform) of a material's base color image; if there is none, of its normal map, of its
 * emission image or of its metallic-roughness image.
 *
 * @param set index of the primitive's texture coordinates
 * @param matrix u′ = map₀·u + map₁·v + map₂, v′ = map₃·u + map₄·v + map₅
 */
record TextureTransform(int set, double[] matrix) {
    static TextureTransform of(GltfFile file, int material) {
        if (material < 0) {
            return new TextureTransform(0, new double[] {1, 0, 0, 0, 1, 0});
        }
        try {
            return ofMaterial(file.array("materials").element(material));
        } catch (MeshException e) {
            // The reader of the materials notes it.
            return new TextureTransform(0, new double[] {1, 0, 0, 0, 1, 0});
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
        return Stream.of(pbr.get("baseColorTexture"), material.get("normalTexture"), material.get("emissiveTexture"))
                .filter(JsonValue::isPresent).findFirst().orElse(pbr.get("metallicRoughnessTexture"));
    }

    /** Returns whether two placements are the same. */
    boolean isSame(TextureTransform other) {
        return set == other.set && Arrays.equals(matrix, other.matrix);
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
        return new TextureTransform(set, new double[] {c * scale[0], s * scale[1], offset[0], -s * scale[0], c * scale[1], offset[1]});
    }

    /** Returns whether two textures of a material have the same placement. */
    static boolean areSame(JsonValue texture, JsonValue other) throws MeshException {
        return of(texture).isSame(of(other));
    }

    /** Transforms glTF coordinates, whose v points down, to coordinates whose v points up. */
    void apply(float[] coordinates) {
        for (int i = 0; i < coordinates.length; i += 2) {
            double u = coordinates[i];
            double v = coordinates[i + 1];
            coordinates[i] = (float) (matrix[0] * u + matrix[1] * v + matrix[2]);
            coordinates[i + 1] = (float) (1 - (matrix[3] * u + matrix[4] * v + matrix[5]));
        }
    }
}
