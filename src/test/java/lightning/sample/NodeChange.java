package lightning.sample;

import lightning.base.math.Vec3;
import lightning.scene.NodeGroup;
import lightning.scene.Placement;
import lightning.scene.SceneNode;
import lightning.scene.Shape;
import lightning.scene.Solid;

/** A change of one shape or group. */
public sealed interface NodeChange {
    SceneNode on(SceneNode node);

    /** From where it stands. */
    record Move(Vec3 by) implements NodeChange {
        @Override
        public SceneNode on(SceneNode node) {
            Placement p = node.placement();
            return node.withPlacement(new Placement(p.position().plus(by), p.rotation(), p.scale()));
        }
    }

    /** To degrees about x, y and z. */
    record Turn(Vec3 to) implements NodeChange {
        @Override
        public SceneNode on(SceneNode node) {
            return node.withPlacement(new Placement(node.placement().position(), to, node.placement().scale()));
        }
    }

    record Scale(Vec3 to) implements NodeChange {
        @Override
        public SceneNode on(SceneNode node) {
            return node.withPlacement(new Placement(node.placement().position(), node.placement().rotation(), to));
        }
    }

    /** Hidden where it is visible, visible where it is hidden. */
    record ToggleVisible() implements NodeChange {
        @Override
        public SceneNode on(SceneNode node) {
            return node.withVisible(!node.visible());
        }
    }

    /** Shapes alone have a material. */
    record AssignMaterial(String material) implements NodeChange {
        @Override
        public SceneNode on(SceneNode node) {
            return switch (node) {
                case Shape s -> s.withMaterial(material);
                case NodeGroup g -> g;
            };
        }
    }

    /** The colors of a mesh's vertices shown where they were not, not shown where they were. */
    record ToggleVertexColors() implements NodeChange {
        @Override
        public SceneNode on(SceneNode node) {
            return node instanceof Shape s && s.solid() instanceof Solid.TriangleMesh t ? s.withSolid(t.withShowsColors(!t.showsColors()))
                    : node;
        }
    }

    /** Another solid in a shape's place. */
    record ReplaceSolid(Solid solid) implements NodeChange {
        @Override
        public SceneNode on(SceneNode node) {
            return switch (node) {
                case Shape s -> s.withSolid(solid);
                case NodeGroup g -> g;
            };
        }
    }
}
