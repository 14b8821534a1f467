package lightning.render.relight;

import lightning.scene.Contribution;

/**
 * Contribution of one light to a picture.
 *
 * @param light         the light or environment
 * @param shines        true if it contributes at all: it is on and not muted by a solo light
 * @param imageShare    its part of the picture's mean luminance; 0 for a black picture
 * @param regionShare   its part of a region's mean luminance
 * @param changeWhenOff change of the picture when the light is switched off
 */
public record LightContribution(Contribution light, boolean shines, double imageShare, double regionShare, FilmChange changeWhenOff) {}
