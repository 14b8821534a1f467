package lightning.format.gltf;

import lightning.scene.asset.TextureWrap;

/**
 * Image that a material of a glTF file shows.
 *
 * @param index index of the image; −1 for none
 * @param wrap  continuation beyond its edges
 */
public record GltfImage(int index, TextureWrap wrap) {
    static final GltfImage NONE = new GltfImage(-1, TextureWrap.REPEAT);

    /** Returns whether there is an image. */
    public boolean isPresent() {
        return index >= 0;
    }
}
