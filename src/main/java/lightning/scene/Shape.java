package lightning.scene;

/**
 * A solid that is put into the scene by its placement.
 *
 * @param material the name of a material of the scene
 * @param visible  whether it is there at all: a shape that is not is neither seen nor throws a shadow
 */
public record Shape(Solid solid, String name, String material, Placement placement, boolean visible) implements SceneNode {
    public Shape {
        SceneLimits.checkName(name);
    }

    /** A visible one. */
    public Shape(Solid solid, String name, String material, Placement placement) {
        this(solid, name, material, placement, true);
    }

    /** An attribute of a solid as one of the shape that has it. */
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
