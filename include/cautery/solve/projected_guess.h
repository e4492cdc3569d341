// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/linear_algebra.h>

#include <vector>

namespace Cautery
{
  /**
   * The best combination of earlier solutions as a first guess: Fischer, Comput. Methods Appl. Mech. Eng. 163
   * (1998) 193-204. Keeps an A-orthonormal basis of what earlier solves had to add to their guesses, together
   * with its images under A, so that a guess and its residual cost inner products and no matrix. All arrays
   * are local and contiguous, with one reduction over the processes for all products: for small systems that
   * is what the time goes into.
   */
  class ProjectedGuess
  {
  public:
    explicit ProjectedGuess(const unsigned int capacity) : capacity(capacity) {}

    /** Forgets everything: the matrix is another one. */
    void clear();

    /** Sets @p x to the guess for A x = b and turns @p residual, on entry b, into b - A x. */
    void apply(Vector &x, Vector &residual) const;

    /**
     * Learns the correction @p x - guess, with its image A (x - guess); once full, starts again from the
     * whole solution @p x and its image.
     */
    void learn(const Vector &x, const Vector &image_of_x, const Vector &correction, const Vector &image);

    unsigned int size() const { return n_directions; }

  private:
    std::vector<double> products(const std::vector<double> &columns, const Vector &x) const;
    bool                add(const Vector &direction, const Vector &image);

    const unsigned int  capacity;
    unsigned int        n_directions = 0;
    std::vector<double> directions; ///< one after the other
    std::vector<double> images;
  };
} // namespace Cautery
