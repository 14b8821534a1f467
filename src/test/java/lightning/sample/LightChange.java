package lightning.sample;

import lightning.base.math.Rgb;
import lightning.scene.Area;
import lightning.scene.Attenuation;
import lightning.scene.Light;
import lightning.scene.LightAttribute;
import lightning.scene.LightType;
import lightning.scene.Scene;

/** A new value for one of a light's attributes. */
sealed interface LightChange {

    /** The light with the new value. */
    Light on(Light light, Scene scene);

    record Color(Rgb to) implements LightChange {
        @Override
        public Light on(Light light, Scene scene) {
            return light.withColor(to);
        }
    }

    record Intensity(double to) implements LightChange {
        @Override
        public Light on(Light light, Scene scene) {
            return light.withIntensity(to);
        }
    }

    record Fading(Attenuation to) implements LightChange {
        @Override
        public Light on(Light light, Scene scene) {
            return light.withAttenuation(to);
        }
    }

    record Angle(double to) implements LightChange {
        @Override
        public Light on(Light light, Scene scene) {
            return light.withAngle(to);
        }
    }

    record Dropoff(double to) implements LightChange {
        @Override
        public Light on(Light light, Scene scene) {
            return light.withDropoff(to);
        }
    }

    record Type(LightType to) implements LightChange {
        @Override
        public Light on(Light light, Scene scene) {
            return light.withType(to);
        }
    }

    record Size(Area to) implements LightChange {
        @Override
        public Light on(Light light, Scene scene) {
            return light.withArea(to);
        }
    }

    record SwitchOn() implements LightChange {
        @Override
        public Light on(Light light, Scene scene) {
            return light.withOn(!light.on());
        }
    }

    record SwitchSolo() implements LightChange {
        @Override
        public Light on(Light light, Scene scene) {
            return light.withSolo(!light.solo());
        }
    }

    record Move(Place to) implements LightChange {
        @Override
        public Light on(Light light, Scene scene) {
            return light.withPosition(to.in(scene));
        }
    }

    record Turn(Place to) implements LightChange {
        @Override
        public Light on(Light light, Scene scene) {
            return light.withDirection(LightSeed.direction(light.position(), to.in(scene)));
        }
    }

    /** Another length of the direction, which no picture shows. */
    record Lengthen(double factor) implements LightChange {
        @Override
        public Light on(Light light, Scene scene) {
            return light.withDirection(light.direction().normalized().times(factor));
        }
    }

    /** Any attribute that the table has. */
    record Anew<V>(LightAttribute<V> attribute, V to) implements LightChange {
        @Override
        public Light on(Light light, Scene scene) {
            Light anew = attribute.with(light, to);
            return anew.withIlluminates(anew.illuminates().within(scene.stage()::hasNode))
                    .withShadowedBy(anew.shadowedBy().within(scene.stage()::hasNode));
        }
    }
}
