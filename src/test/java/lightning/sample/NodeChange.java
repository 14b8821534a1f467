package lightning.sample;

import lightning.base.math.Vec3;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;

/** Change of one shape or group. */
public sealed interface NodeChange {
    SceneNode on(SceneNode node);

    /** Moves it relative to its position. */
    record Move(Vec3 by) implements NodeChange {
        @Override
        public SceneNode on(SceneNode node) {
            Placement p = node.placement();
            return node.withPlacement(new Placement(p.position().plus(by), p.rotation(), p.scale()));
        }
    }

    /** Sets its rotation, degrees about x, y and z. */
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

    /** Toggles its visibility. */
    record ToggleVisible() implements NodeChange {
        @Override
        public SceneNode on(SceneNode node) {
            return node.withVisible(!node.visible());
        }
    }

    /** Assigns a material; has no effect on groups. */
    record AssignMaterial(String material) implements NodeChange {
        @Override
        public SceneNode on(SceneNode node) {
            return switch (node) {
                case Shape s -> s.withMaterial(material);
                case NodeGroup g -> g;
            };
        }
    }

    /** Toggles a mesh's vertex colors. */
    record ToggleVertexColors() implements NodeChange {
        @Override
        public SceneNode on(SceneNode node) {
            return node instanceof Shape s && s.solid() instanceof Solid.TriangleMesh t ? s.withSolid(t.withShowsColors(!t.showsColors()))
                    : node;
        }
    }

    /** Replaces a shape's solid. */
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
