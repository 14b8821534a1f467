package lightning.format.gltf;

import lightning.base.math.Affine2;
import lightning.scene.asset.TextureWrap;

/**
 * Image that a material of a glTF file shows.
 *
 * @param index index of the image; −1 for none
 * @param wrap  continuation beyond its edges
 * @param map   from the texture coordinates of the material's meshes to those of the image
 */
public record GltfImage(int index, TextureWrap wrap, Affine2 map) {
    static final GltfImage NONE = new GltfImage(-1, TextureWrap.REPEAT, Affine2.IDENTITY);

    /** Returns whether there is an image. */
    public boolean isPresent() {
        return index >= 0;
    }
}
