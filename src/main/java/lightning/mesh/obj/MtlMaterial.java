package lightning.mesh.obj;

import java.util.Optional;
import lightning.math.Rgb;

/**
 * A material of an MTL file.
 *
 * @param name      as the file writes it
 * @param diffuse   Kd, as written; the same of all colours
 * @param specular  Ks
 * @param emission  Ke
 * @param shininess Ns, the exponent of Phong's highlight
 * @param mirrors   whether its model of illumination ({@code illum} 3 and those beyond) has mirrored rays
 * @param opacity   d: how much of it is there, 1 is all
 * @param filter    Tf, what is seen through it is multiplied by
 * @param ior       Ni, the index of refraction
 * @param refracts  whether its model of illumination (6 and 7) bends what is seen through it
 * @param texture   the picture of the diffuse colour, as written
 * @param cutout    the picture of what is there, as written
 */
public record MtlMaterial(String name, Rgb diffuse, Rgb specular, Rgb emission, double shininess, boolean mirrors, double opacity,
        Rgb filter, double ior, boolean refracts, Optional<String> texture, Optional<String> cutout) {}
