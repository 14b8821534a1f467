/**
 * JavaFX's headless platform without a screen, for {@code -Dglass.platform=Unseen}. The toolkit finds a platform by the name of its
 * package, so this one cannot be elsewhere.
 */
package com.sun.glass.ui.unseen;
