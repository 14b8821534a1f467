/** Content of files that a scene uses: textures, environment maps, gobos and IES profiles. */
@NullMarked
package lightning.scene.asset;

import org.jspecify.annotations.NullMarked;
