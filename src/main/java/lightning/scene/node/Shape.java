package lightning.scene.node;

import lightning.scene.attribute.SceneAttribute;
import lightning.scene.value.Placement;
import lightning.scene.value.SceneLimits;

/**
 * Solid with a placement and a material.
 *
 * @param material name of a material of the scene
 * @param visible  false if it is neither visible nor casts shadows
 */
public record Shape(Solid solid, String name, String material, Placement placement, boolean visible) implements SceneNode {
    public Shape {
        SceneLimits.checkName(name);
    }

    /** Creates a visible shape. */
    public Shape(Solid solid, String name, String material, Placement placement) {
        this(solid, name, material, placement, true);
    }

    /** Adapts an attribute of a solid to the shape that has it. */
    static <V> SceneAttribute<SceneNode, V> attribute(SceneAttribute<Solid.Canonical, V> a) {
        return new SceneAttribute<>(a.name(), a.title(), a.kind(), a.initial(), a.unit(), n -> a.get((Solid.Canonical) ((Shape) n).solid),
                (n, v) -> ((Shape) n).withSolid(a.with((Solid.Canonical) ((Shape) n).solid, v)));
    }

    public Shape withName(String v) {
        return new Shape(solid, v, material, placement, visible);
    }

    public Shape withSolid(Solid v) {
        return new Shape(v, name, material, placement, visible);
    }

    public Shape withMaterial(String v) {
        return new Shape(solid, name, v, placement, visible);
    }

    @Override
    public Shape withPlacement(Placement v) {
        return new Shape(solid, name, material, v, visible);
    }

    @Override
    public Shape withVisible(boolean v) {
        return new Shape(solid, name, material, placement, v);
    }
}
