package lightning.base.math;

/** A half-line in render space; distances along it are in units of the direction's length. */
public record Ray(Vec3 origin, Vec3 direction) {}
