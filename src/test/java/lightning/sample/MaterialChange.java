package lightning.sample;

import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.scene.Clarity;
import lightning.scene.Cutout;
import lightning.scene.Material;
import lightning.scene.MaterialAttribute;
import lightning.scene.Relief;
import lightning.scene.ShadowsThrown;
import lightning.scene.SurfaceModel;
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

    record Model(SurfaceModel to) implements MaterialChange {
        @Override
        public Material on(Material material) {
            return material.withModel(to);
        }
    }

    record Base(Rgb to) implements MaterialChange {
        @Override
        public Material on(Material material) {
            return material.withBase(to);
        }
    }

    record Metalness(double to) implements MaterialChange {
        @Override
        public Material on(Material material) {
            return material.withMetalness(to);
        }
    }

    record Roughness(double to) implements MaterialChange {
        @Override
        public Material on(Material material) {
            return material.withRoughness(to);
        }
    }

    record F0(double to) implements MaterialChange {
        @Override
        public Material on(Material material) {
            return material.withF0(to);
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

    record Relieved(Relief to) implements MaterialChange {
        @Override
        public Material on(Material material) {
            return material.withRelief(to);
        }
    }

    record Cleared(Clarity to) implements MaterialChange {
        @Override
        public Material on(Material material) {
            return material.withClarity(to);
        }
    }

    record Clear(Rgb to) implements MaterialChange {
        @Override
        public Material on(Material material) {
            return material.withClarity(material.clarity().withClear(to));
        }
    }

    record Ior(double to) implements MaterialChange {
        @Override
        public Material on(Material material) {
            return material.withClarity(material.clarity().withIor(to));
        }
    }

    record Thin(boolean to) implements MaterialChange {
        @Override
        public Material on(Material material) {
            return material.withClarity(material.clarity().withThin(to));
        }
    }

    record Tint(Rgb to, double distance) implements MaterialChange {
        @Override
        public Material on(Material material) {
            return material.withClarity(material.clarity().withTint(to).withTintDistance(distance));
        }
    }

    record Shadows(ShadowsThrown to) implements MaterialChange {
        @Override
        public Material on(Material material) {
            return material.withClarity(material.clarity().withShadows(to));
        }
    }

    record Cut(Cutout to) implements MaterialChange {
        @Override
        public Material on(Material material) {
            return material.withCutout(to);
        }
    }

    record Everything(Material to) implements MaterialChange {
        @Override
        public Material on(Material material) {
            return to.withName(material.name());
        }
    }

    /** Any attribute that the table has. */
    record Anew<V>(MaterialAttribute<V> attribute, V to) implements MaterialChange {
        @Override
        public Material on(Material material) {
            return attribute.with(material, to);
        }
    }
}
