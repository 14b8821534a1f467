package lightning.render.engine.lanes;

import jdk.incubator.vector.DoubleVector;
import lightning.render.trace.CameraRays;
import lightning.render.trace.solid.Lanes;

/** {@link CameraRays#through} in lanes, operation by operation. */
final class EyeLanes {
    private static final DoubleVector COUNT = DoubleVector.zero(Lanes.SPECIES).addIndex(1);

    private EyeLanes() {}

    /** Directs rays {@code at …} through the pixel {@code column, row} and those to the right of it. */
    static void through(CameraRays camera, int column, int row, double[] toX, double[] toY, double[] toZ, int at) {
        double y = row + 0.5;
        double downX = y * camera.down.x();
        double downY = y * camera.down.y();
        double downZ = y * camera.down.z();
        for (int h = 0; h < RayPacket.WIDTH; h += Lanes.COUNT) {
            DoubleVector x = COUNT.add(column + h + 0.5);
            DoubleVector dx = x.mul(camera.right.x()).add(camera.corner.x()).add(downX);
            DoubleVector dy = x.mul(camera.right.y()).add(camera.corner.y()).add(downY);
            DoubleVector dz = x.mul(camera.right.z()).add(camera.corner.z()).add(downZ);
            DoubleVector length = dx.mul(dx).add(dy.mul(dy)).add(dz.mul(dz)).sqrt();
            dx.div(length).intoArray(toX, at + h);
            dy.div(length).intoArray(toY, at + h);
            dz.div(length).intoArray(toZ, at + h);
        }
    }

    /** Directs rays {@code at …} through the picture coordinates {@code x[i], y[i]}; both arrays as long as a packet. */
    static void at(CameraRays camera, double[] x, double[] y, double[] toX, double[] toY, double[] toZ, int at) {
        for (int h = 0; h < RayPacket.WIDTH; h += Lanes.COUNT) {
            DoubleVector across = DoubleVector.fromArray(Lanes.SPECIES, x, h);
            DoubleVector along = DoubleVector.fromArray(Lanes.SPECIES, y, h);
            DoubleVector dx = across.mul(camera.right.x()).add(camera.corner.x()).add(along.mul(camera.down.x()));
            DoubleVector dy = across.mul(camera.right.y()).add(camera.corner.y()).add(along.mul(camera.down.y()));
            DoubleVector dz = across.mul(camera.right.z()).add(camera.corner.z()).add(along.mul(camera.down.z()));
            DoubleVector length = dx.mul(dx).add(dy.mul(dy)).add(dz.mul(dz)).sqrt();
            dx.div(length).intoArray(toX, at + h);
            dy.div(length).intoArray(toY, at + h);
            dz.div(length).intoArray(toZ, at + h);
        }
    }
}
