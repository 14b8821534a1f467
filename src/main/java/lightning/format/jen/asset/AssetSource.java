package lightning.format.jen.asset;

import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureUsage;
import lightning.scene.node.Mesh;
import lightning.scene.value.Photometry;

/** Source of the assets that a scene references. */
public interface AssetSource {
    /** Source of no assets. */
    AssetSource NONE = new AssetSource() {
        @Override
        public Texture texture(String file, TextureUsage samples) {
            throw missing(file);
        }

        @Override
        public Photometry profile(String file) {
            throw missing(file);
        }

        @Override
        public EnvironmentMap environment(String file) {
            throw missing(file);
        }

        @Override
        public Mesh mesh(String file, String part) {
            throw missing(file);
        }

        private RefusalException missing(String file) {
            return new RefusalException("expected no file, found " + Quote.of(file));
        }
    };

    /**
     * Returns a texture.
     *
     * @param samples meaning of the samples
     * @throws IllegalArgumentException if it cannot be used; the message contains the cause
     */
    Texture texture(String file, TextureUsage samples);

    /**
     * Returns a photometric profile.
     *
     * @throws IllegalArgumentException if it cannot be used; the message contains the cause
     */
    Photometry profile(String file);

    /**
     * Returns an environment map.
     *
     * @throws IllegalArgumentException if it cannot be used; the message contains the cause
     */
    EnvironmentMap environment(String file);

    /**
     * Returns a mesh.
     *
     * @param part name of a part of the file; empty for all parts
     * @throws IllegalArgumentException if it cannot be used; the message contains the cause
     */
    Mesh mesh(String file, String part);
}
