/**
 * Files of many programs through the library Assimp: it converts them to glTF, which {@code GltfImport} reads.
 *
 * <p>Assimp is native code that crashes on some damaged files. Therefore {@link lightning.format.assimp.AssimpConverter} starts this program
 * again, and only {@link lightning.format.assimp.AssimpProcess} there loads the library.
 */
@NullMarked
package lightning.format.assimp;

import org.jspecify.annotations.NullMarked;
