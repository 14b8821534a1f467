/**
 * Render effects used by a scene, found without rendering.
 *
 * <pre>{@code
 * SceneEffects effects = SceneEffects.of(scene);
 * effects.has(RenderEffect.TEXTURES);           // false: no surface is textured
 * effects.users(RenderEffect.ATTENUATION);      // [lamp]
 * }</pre>
 *
 * <p>A scene uses an effect if removing it could change the image. Unused parts of the scene (a light that is off, a material without
 * shapes, mirrors at depth 0) use no effect.
 */
@NullMarked
package lightning.scene.effects;

import org.jspecify.annotations.NullMarked;
