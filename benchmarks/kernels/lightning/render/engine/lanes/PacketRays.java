package lightning.render.engine.lanes;

import lightning.base.math.Ray;

/** Loading of rays into packets. */
final class PacketRays {
    private PacketRays() {}

    static void setRay(RayPacket p, int lane, Ray ray, double limit) {
        p.ox[lane] = ray.origin().x();
        p.oy[lane] = ray.origin().y();
        p.oz[lane] = ray.origin().z();
        p.dx[lane] = ray.direction().x();
        p.dy[lane] = ray.direction().y();
        p.dz[lane] = ray.direction().z();
        p.limit[lane] = limit;
    }
}
