package lightning.sample;

import lightning.base.math.Vec3;
import lightning.scene.Group;
import lightning.scene.Node;
import lightning.scene.Placement;
import lightning.scene.Shape;
import lightning.scene.Solid;

/** A change of one shape or group. */
public sealed interface NodeChange {
    Node on(Node node);

    /** From where it stands. */
    record Move(Vec3 by) implements NodeChange {
        @Override
        public Node on(Node node) {
            Placement p = node.placement();
            return node.withPlacement(new Placement(p.at().plus(by), p.rotate(), p.scale()));
        }
    }

    /** To degrees about x, y and z. */
    record Turn(Vec3 to) implements NodeChange {
        @Override
        public Node on(Node node) {
            return node.withPlacement(new Placement(node.placement().at(), to, node.placement().scale()));
        }
    }

    record Scale(Vec3 to) implements NodeChange {
        @Override
        public Node on(Node node) {
            return node.withPlacement(new Placement(node.placement().at(), node.placement().rotate(), to));
        }
    }

    /** Hidden where it is visible, visible where it is hidden. */
    record Show() implements NodeChange {
        @Override
        public Node on(Node node) {
            return node.withVisible(!node.visible());
        }
    }

    /** Shapes alone have a material. */
    record Paint(String material) implements NodeChange {
        @Override
        public Node on(Node node) {
            return switch (node) {
                case Shape s -> s.withMaterial(material);
                case Group g -> g;
            };
        }
    }

    /** The colours of a mesh's vertices shown where they were not, not shown where they were. */
    record Tint() implements NodeChange {
        @Override
        public Node on(Node node) {
            return node instanceof Shape s && s.solid() instanceof Solid.Triangles t ? s.withSolid(t.withColors(!t.colors())) : node;
        }
    }

    /** Another solid in a shape's place. */
    record Become(Solid solid) implements NodeChange {
        @Override
        public Node on(Node node) {
            return switch (node) {
                case Shape s -> s.withSolid(solid);
                case Group g -> g;
            };
        }
    }
}
