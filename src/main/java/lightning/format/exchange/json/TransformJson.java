package lightning.format.exchange.json;

import java.util.List;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.scene.node.SceneNode;
import tools.jackson.databind.node.ArrayNode;

/** JSON form of the transform of an object, from its coordinates to those of its parent: 16 numbers, column by column as in glTF. */
public final class TransformJson {
    private TransformJson() {}

    public static void write(ArrayNode matrix, SceneNode node) {
        Transform transform = node.placement().transform();
        for (Vec3 axis : List.of(new Vec3(1, 0, 0), Vec3.Y, new Vec3(0, 0, 1))) {
            addColumn(matrix, transform.transformVector(axis), 0);
        }
        addColumn(matrix, transform.transformPoint(Vec3.ZERO), 1);
    }

    private static void addColumn(ArrayNode matrix, Vec3 column, int last) {
        matrix.add(column.x()).add(column.y()).add(column.z()).add(last);
    }
}
