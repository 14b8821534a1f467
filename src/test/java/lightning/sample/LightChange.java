package lightning.sample;

import lightning.base.math.Rgb;
import lightning.scene.Scene;
import lightning.scene.light.AreaShape;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightType;
import lightning.scene.value.Attenuation;

/** New value for one of a light's attributes. */
sealed interface LightChange {

    /** Returns the light with the new value. */
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

    record SetAttenuation(Attenuation to) implements LightChange {
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

    record SetArea(AreaShape to) implements LightChange {
        @Override
        public Light on(Light light, Scene scene) {
            return light.withArea(to).retainLinks(scene.stage()::hasNode);
        }
    }

    record ToggleOn() implements LightChange {
        @Override
        public Light on(Light light, Scene scene) {
            return light.withOn(!light.on());
        }
    }

    record ToggleSolo() implements LightChange {
        @Override
        public Light on(Light light, Scene scene) {
            return light.withSolo(!light.solo());
        }
    }

    record Move(RelativePosition to) implements LightChange {
        @Override
        public Light on(Light light, Scene scene) {
            return light.withPosition(to.in(scene));
        }
    }

    record Turn(RelativePosition to) implements LightChange {
        @Override
        public Light on(Light light, Scene scene) {
            return light.withDirection(LightTemplate.direction(light.position(), to.in(scene)));
        }
    }

    /** Scales the direction, which does not affect the image. */
    record ScaleDirection(double factor) implements LightChange {
        @Override
        public Light on(Light light, Scene scene) {
            return light.withDirection(light.direction().normalized().times(factor));
        }
    }

    /** Sets any attribute of the table. */
    record SetAttribute<V>(LightAttribute<V> attribute, V to) implements LightChange {
        @Override
        public Light on(Light light, Scene scene) {
            return attribute.with(light, to).retainLinks(scene.stage()::hasNode);
        }
    }
}
