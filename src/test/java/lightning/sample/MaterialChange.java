package lightning.sample;

import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.scene.asset.TextureMap;
import lightning.scene.material.AlphaCutout;
import lightning.scene.material.BumpMapping;
import lightning.scene.material.Material;
import lightning.scene.material.MaterialAttribute;
import lightning.scene.material.ShadingModel;
import lightning.scene.material.ShadowCasting;
import lightning.scene.material.Transmission;

/** New value for one of a material's properties, or for all. */
sealed interface MaterialChange {

    /** Returns the material with the new value. */
    Material on(Material material);

    record Ambient(Rgb to) implements MaterialChange {
        @Override
        public Material on(Material material) {
            return material.withAmbient(to);
        }
    }

    record Glow(Rgb to) implements MaterialChange {
        @Override
        public Material on(Material material) {
            return material.withGlow(to);
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

    record Model(ShadingModel to) implements MaterialChange {
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

    record SetTexture(Optional<TextureMap> to) implements MaterialChange {
        @Override
        public Material on(Material material) {
            return material.withTexture(to);
        }
    }

    record SetBumpMapping(BumpMapping to) implements MaterialChange {
        @Override
        public Material on(Material material) {
            return material.withBumpMapping(to);
        }
    }

    record SetTransmission(Transmission to) implements MaterialChange {
        @Override
        public Material on(Material material) {
            return material.withTransmission(to);
        }
    }

    record SetTransmissionColor(Rgb to) implements MaterialChange {
        @Override
        public Material on(Material material) {
            return material.withTransmission(material.transmission().withColor(to));
        }
    }

    record Ior(double to) implements MaterialChange {
        @Override
        public Material on(Material material) {
            return material.withTransmission(material.transmission().withIor(to));
        }
    }

    record Thin(boolean to) implements MaterialChange {
        @Override
        public Material on(Material material) {
            return material.withTransmission(material.transmission().withThin(to));
        }
    }

    record Tint(Rgb to, double distance) implements MaterialChange {
        @Override
        public Material on(Material material) {
            return material.withTransmission(material.transmission().withTint(to).withTintDistance(distance));
        }
    }

    record Shadows(ShadowCasting to) implements MaterialChange {
        @Override
        public Material on(Material material) {
            return material.withTransmission(material.transmission().withShadows(to));
        }
    }

    record SetCutout(AlphaCutout to) implements MaterialChange {
        @Override
        public Material on(Material material) {
            return material.withCutout(to);
        }
    }

    record ReplaceMaterial(Material to) implements MaterialChange {
        @Override
        public Material on(Material material) {
            return to.withName(material.name());
        }
    }

    /** Sets any attribute of the table. */
    record SetAttribute<V>(MaterialAttribute<V> attribute, V to) implements MaterialChange {
        @Override
        public Material on(Material material) {
            return attribute.with(material, to);
        }
    }
}
