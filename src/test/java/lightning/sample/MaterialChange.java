package lightning.sample;

import java.util.Optional;
import lightning.math.Rgb;
import lightning.scene.Material;
import lightning.scene.TextureMap;

/** A new value for one of a material's properties, or for all. */
sealed interface MaterialChange {

    /** The material with the new value. */
    Material on(Material material);

    record Ambient(Rgb to) implements MaterialChange {
        @Override
        public Material on(Material material) {
            return material.withAmbient(to);
        }
    }

    record Diffuse(Rgb to) implements MaterialChange {
        @Override
        public Material on(Material material) {
            return material.withDiffuse(to);
        }
    }

    record Specular(Rgb to) implements MaterialChange {
        @Override
        public Material on(Material material) {
            return material.withSpecular(to);
        }
    }

    record Shininess(double to) implements MaterialChange {
        @Override
        public Material on(Material material) {
            return material.withShininess(to);
        }
    }

    record Reflective(Rgb to) implements MaterialChange {
        @Override
        public Material on(Material material) {
            return material.withReflective(to);
        }
    }

    record Textured(Optional<TextureMap> to) implements MaterialChange {
        @Override
        public Material on(Material material) {
            return material.withTexture(to);
        }
    }

    record Everything(Material to) implements MaterialChange {
        @Override
        public Material on(Material material) {
            return Material.of(material.name()).withAmbient(to.ambient()).withDiffuse(to.diffuse()).withSpecular(to.specular())
                    .withShininess(to.shininess()).withReflective(to.reflective()).withTexture(to.texture());
        }
    }
}
