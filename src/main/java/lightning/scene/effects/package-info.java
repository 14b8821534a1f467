/**
 * What a scene calls for, from the scene alone: nothing is rendered to find out.
 *
 * <pre>{@code
 * SceneEffects effects = SceneEffects.of(scene);
 * effects.has(RenderEffect.TEXTURES);           // false: no surface is textured
 * effects.callers(RenderEffect.ATTENUATION);    // [lamp]
 * }</pre>
 *
 * <p>An effect is called for when the picture could be another one without it. What the scene holds but does not use
 * (a light that is off, a material on no shape, mirrors at depth 0) calls for nothing.
 */
package lightning.scene.effects;
