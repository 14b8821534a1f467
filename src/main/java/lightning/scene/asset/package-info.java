/**
 * Content of files that a scene uses: textures, environment maps, gobos and IES profiles.
 * Values only: {@code format.jen.asset} finds and decodes the files.
 */
@NullMarked
package lightning.scene.asset;

import org.jspecify.annotations.NullMarked;
