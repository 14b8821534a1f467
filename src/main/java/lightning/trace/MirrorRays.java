package lightning.trace;

/** The rays that mirroring rows cast. */
final class MirrorRays {
    private MirrorRays() {}

    /** Writes the direction of the mirrored ray of row {@code r}, as {@link SurfacePoint#mirrored}, to place {@code at}. */
    static void direction(HitRows from, int r, double[] dx, double[] dy, double[] dz, int at) {
        double nx = from.nx[r];
        double ny = from.ny[r];
        double nz = from.nz[r];
        double twice = 2 * Math.abs(nx * from.vx[r] + ny * from.vy[r] + nz * from.vz[r]);
        double rx = from.vx[r] + twice * nx;
        double ry = from.vy[r] + twice * ny;
        double rz = from.vz[r] + twice * nz;
        double length = Math.sqrt(rx * rx + ry * ry + rz * rz);
        dx[at] = rx / length;
        dy[at] = ry / length;
        dz[at] = rz / length;
    }
}
