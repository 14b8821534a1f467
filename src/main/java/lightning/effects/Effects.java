package lightning.effects;

import java.util.Collections;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import lightning.scene.Light;
import lightning.scene.Material;
import lightning.scene.PlacedShape;
import lightning.scene.Scene;
import lightning.scene.Shape;

/**
 * The effects that a scene calls for, and who calls for each.
 *
 * @param callers for each effect that is called for the names of the lights, materials or shapes that do, in the order
 *                of the scene, each once; other effects have no entry
 * @param depth   how many mirror bounces a ray can make at most: 0 where nothing mirrors
 */
public record Effects(Map<Effect, List<String>> callers, int depth) {

    public Effects {
        var copy = new EnumMap<Effect, List<String>>(Effect.class);
        callers.forEach((effect, names) -> copy.put(effect, List.copyOf(names)));
        callers = Collections.unmodifiableMap(copy);
    }

    /** The effects of a scene. */
    public static Effects of(Scene scene) {
        var callers = new EnumMap<Effect, Set<String>>(Effect.class);
        List<PlacedShape> shapes = scene.placedShapes();
        List<Light> shining = scene.lights().stream().filter(l -> shines(scene, l)).toList();
        for (PlacedShape shape : shapes) {
            call(callers, effect(shape.shape()), shape.shape().name());
            material(callers, shape.material(), scene, !shining.isEmpty());
        }
        if (!shapes.isEmpty()) {
            shining.forEach(light -> light(callers, light));
        }
        var lists = new EnumMap<Effect, List<String>>(Effect.class);
        callers.forEach((effect, names) -> lists.put(effect, List.copyOf(names)));
        return new Effects(lists, callers.containsKey(Effect.REFLECTION) ? scene.picture().depth() : 0);
    }

    private static boolean shines(Scene scene, Light light) {
        return scene.shines(light) && light.intensity() > 0 && !light.color().isBlack();
    }

    private static void material(Map<Effect, Set<String>> callers, Material m, Scene scene, boolean lit) {
        if (lit && !m.specular().isBlack()) {
            call(callers, Effect.SPECULAR, m.name());
        }
        if (lit && m.texture().isPresent() && !m.diffuse().isBlack()) {
            call(callers, Effect.TEXTURES, m.name());
        }
        if (scene.picture().depth() > 0 && !m.reflective().isBlack()) {
            call(callers, Effect.REFLECTION, m.name());
        }
    }

    private static void light(Map<Effect, Set<String>> callers, Light light) {
        call(callers, Effect.SHADOWS, light.name());
        switch (light.type()) {
            case DIRECTIONAL -> call(callers, Effect.DIRECTIONAL_LIGHTS, light.name());
            case POINT -> call(callers, Effect.POINT_LIGHTS, light.name());
            case SPOT -> {
                call(callers, Effect.SPOT_LIGHTS, light.name());
                if (light.angle() < 180) {
                    call(callers, Effect.SPOT_CONE, light.name());
                }
                if (light.dropoff() != 0) {
                    call(callers, Effect.DROPOFF, light.name());
                }
            }
        }
        if (light.type().hasPosition() && !light.attenuation().isNone()) {
            call(callers, Effect.ATTENUATION, light.name());
        }
    }

    private static Effect effect(Shape shape) {
        return switch (shape) {
            case Shape.Sphere _ -> Effect.SPHERES;
            case Shape.Cone _ -> Effect.CONES;
            case Shape.Cylinder _ -> Effect.CYLINDERS;
            case Shape.Plane _ -> Effect.PLANES;
        };
    }

    private static void call(Map<Effect, Set<String>> callers, Effect effect, String name) {
        callers.computeIfAbsent(effect, _ -> new LinkedHashSet<>()).add(name);
    }

    /** Whether the scene calls for an effect. */
    public boolean has(Effect effect) {
        return callers.containsKey(effect);
    }

    /** Who calls for it; empty where nobody does. */
    public List<String> callers(Effect effect) {
        return callers.getOrDefault(effect, List.of());
    }

    /** What the scene does without. */
    public Set<Effect> absent() {
        var absent = EnumSet.allOf(Effect.class);
        absent.removeAll(callers.keySet());
        return absent;
    }
}
